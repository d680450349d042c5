/* Rigid bodies whose members were moved, or got other velocities, by commands between runs. */
#ifndef TS_RIGID_RIGID_FOLLOW_H
#define TS_RIGID_RIGID_FOLLOW_H

#include "rigid/rigid.h"

/* When a run begins: bodies of members with other velocities than theirs get the nearest rigid motion. */
enum ts_status ts_rigid_take_velocities(struct tsim *sim);

/* The same at once for the clumps with all their spheres in the group, to which a command has given other velocities: sums
 * over groups count clumps as bodies (rigid/rigid_share.h). */
enum ts_status ts_rigid_take_clump_velocities(struct tsim *sim, int group);

/* Bodies follow their members, which the command `who` has moved or left behind in another box: they are displaced, and, if
 * the command `reshapes`, those whose members were moved apart become the bodies of the spheres where they are now, but
 * clumps are refused. Else the shape is kept. */
enum ts_status ts_rigid_follow(struct tsim *sim, bool reshapes, const char *who,
			       const struct ts_place *where);

#endif
