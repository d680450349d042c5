/* Sub-step contact detection (law/substep.h): when `located yes` is allowed. */
#ifndef TS_CONTACT_SUBSTEP_CONTACTS_H
#define TS_CONTACT_SUBSTEP_CONTACTS_H

#include "core/sim.h"
#include "law/substep.h"

/* Fails if a model with `located yes` cannot be combined with the other settings of the run; to be called
 * before a run, when all styles are known. */
enum ts_status ts_substep_check(struct tsim *sim, const struct ts_granular_model *model,
				const struct ts_place *where);

#endif
