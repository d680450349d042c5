/* Height fields whose columns are springs, `winkler` of fix surface/voxel: a contact point on a column yields along the
 * axis of the heights, law/foundation.h. The deflection follows from the position of the particle alone, so that nothing
 * is stored, and no two contacts know of each other: each has the spring of a whole column of its own. */
#ifndef TS_WALL_VOXEL_FOUNDATION_H
#define TS_WALL_VOXEL_FOUNDATION_H

#include "wall/voxel_wall.h"
#include "wall/wall_queue.h"

/* Moves the contact point of contact k, which touches, to where column and contact law are in balance: its normal, distance
 * and velocity. */
void ts_voxel_foundation_yield(const struct ts_voxel_surface *s, const struct ts_wall_queue *q, size_t k,
			       struct ts_wall_contact_point *point);

/* Slots of the shape. */
enum ts_status ts_voxel_foundation_check(struct ts_instance *self, struct tsim *sim);
const char *ts_voxel_foundation_not_exact(const struct ts_wall *w);

#endif
