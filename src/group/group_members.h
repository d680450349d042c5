/* Members of groups. Whether particle i is in a group: ts_in_group of particle/particles.h. */
#ifndef TS_GROUP_GROUP_MEMBERS_H
#define TS_GROUP_GROUP_MEMBERS_H

#include "particle/particles.h"

/* How many of the particles from .. to-1. */
size_t ts_group_members(const struct ts_particles *p, int group, size_t from, size_t to);
/* Whether groups have, or will have, particles in common: as far as can be told now. */
bool ts_groups_meet(const struct ts_particles *p, int a, int b);

#endif
