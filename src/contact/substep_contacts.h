/* Contacts whose begin and end are found within the step (law/substep.h): when they may be asked for. */
#ifndef TS_CONTACT_SUBSTEP_CONTACTS_H
#define TS_CONTACT_SUBSTEP_CONTACTS_H

#include "core/sim.h"
#include "law/substep.h"

/* Before a run, when all styles are known. A model that is not located is always right. */
enum ts_status ts_substep_check(struct tsim *sim, const struct ts_granular_model *model,
				const struct ts_place *where);

#endif
