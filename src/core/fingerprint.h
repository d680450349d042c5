/* The fingerprint of a simulation: if it is the same as at the end of the last run, the next run resumes
 * with the forces of the last step. */
#ifndef TS_CORE_FINGERPRINT_H
#define TS_CORE_FINGERPRINT_H

#include "core/sim.h"

/* Hash of all that forces depend on: resolved arguments of pair, bond, flow and fixes; dt; box, columns of
 * particles and what else styles add in their slot `fingerprint`. */
enum ts_status ts_sim_fingerprint(struct tsim *sim, uint64_t *out);

#endif
