/* The fingerprint of a simulation: if it is the same as at the end of the last run, the next run resumes
 * with the forces of the last step. */
#ifndef TS_CORE_FINGERPRINT_H
#define TS_CORE_FINGERPRINT_H

#include "core/sim.h"

/* Hash of all that forces depend on: resolved arguments of pair, bond, flow and fixes; dt; box, columns of
 * particles and what else styles add in their slot `fingerprint`. 0: a variable has no value now, so that it cannot be told
 * whether something has changed. */
enum ts_status ts_sim_fingerprint(struct tsim *sim, uint64_t *out);
/* Whether it is not `before` now, or cannot be told. */
enum ts_status ts_fingerprint_differs(struct tsim *sim, uint64_t before, bool *differs);
/* Whether that of the last run was made by an older version, as read from its restart file: it depends on the order of the
 * particles, and is compared with one that is made so, too. Others have the highest bit. */
bool ts_fingerprint_in_order(const struct tsim *sim);
uint64_t ts_fingerprint_of_old(uint64_t fingerprint);
/* Where an instance that exerts forces is deleted: one like it may follow, which has not had the contacts of this one, so that
 * its forces are to be computed. */
void ts_fingerprint_forget(struct tsim *sim, const struct ts_instance *gone);
/* At the end of a run: sim->run.fingerprint becomes that of its state. */
enum ts_status ts_fingerprint_renew(struct tsim *sim);

#endif
