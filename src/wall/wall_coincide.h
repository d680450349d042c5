/* Particles whose centre lies in the surface of a wall: it is on neither side, and so a contact force has
 * no direction. See neigh/coincide.h. */
#ifndef TS_WALL_WALL_COINCIDE_H
#define TS_WALL_WALL_COINCIDE_H

#include "wall/wall.h"

/* Fails if ts_wall_finish has found a contact whose particle has its centre in the surface of the wall. */
enum ts_status ts_coincide_wall(struct tsim *sim, const struct ts_wall *wall);
/* The same where no forces are computed (-check, -explain): checks the present positions of all listed
 * contacts. For the slot `review` of walls. */
enum ts_status ts_coincide_review(struct ts_instance *self, struct tsim *sim);

#endif
