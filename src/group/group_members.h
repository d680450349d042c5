/* Numbers of members of groups. For a single particle see ts_in_group in particle/particles.h. */
#ifndef TS_GROUP_GROUP_MEMBERS_H
#define TS_GROUP_GROUP_MEMBERS_H

#include "particle/particles.h"

/* Number of members among the particles from <= i < to. */
size_t ts_group_members(const struct ts_particles *p, int group, size_t from, size_t to);
/* Whether two groups have members in common now, or are equal, or one of them is `all`. */
bool ts_groups_meet(const struct ts_particles *p, int a, int b);

#endif
