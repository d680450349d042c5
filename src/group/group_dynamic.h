/* Dynamic groups, whose members are assigned again during a run: particles of the parent group that are
 * in the region and for which the variable is not 0. */
#ifndef TS_GROUP_GROUP_DYNAMIC_H
#define TS_GROUP_GROUP_DYNAMIC_H

#include "core/sim.h"
#include "particle/particles.h"

/* Assigns the members of the group with this bit. */
enum ts_status ts_group_choose(struct tsim *sim, int bit);
/* Evaluates an atom-style variable, NAME or v_NAME. */
enum ts_status ts_group_variable(struct tsim *sim, const char *name, const struct ts_place *where,
				 struct ts_table *out);

/* Assigns the members of all dynamic groups, or of those that are due in this step. */
enum ts_status ts_group_choose_due(struct tsim *sim, bool all);

#endif
