/* Groups whose members are chosen anew while a run goes on: those of the parent that are in the region
 * and for which the variable is not 0. */
#ifndef TS_GROUP_GROUP_DYNAMIC_H
#define TS_GROUP_GROUP_DYNAMIC_H

#include "core/sim.h"
#include "particle/particles.h"

/* Chooses the members now. */
enum ts_status ts_group_choose(struct tsim *sim, int bit);
/* The values of an atom-style variable, NAME or v_NAME. */
enum ts_status ts_group_variable(struct tsim *sim, const char *name, const struct ts_place *where,
				 struct ts_table *out);

/* Chooses the members of all dynamic groups, or of those whose turn it is in this step. */
enum ts_status ts_group_choose_due(struct tsim *sim, bool all);

#endif
