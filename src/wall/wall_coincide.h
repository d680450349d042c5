/* Particles whose centre lies in the surface of a wall: it is on neither side, and so a contact force has
 * no direction. See neigh/coincide.h. */
#ifndef TS_WALL_WALL_COINCIDE_H
#define TS_WALL_WALL_COINCIDE_H

#include "wall/wall.h"

/* Refuses a contact whose particle has its centre in the wall, if ts_wall_finish has found one. */
enum ts_status ts_coincide_wall(struct tsim *sim, const struct ts_wall *wall);
/* The same where nothing is computed (-check, -explain): looks at all contacts that are listed, as they
 * are now. For the slot `review` of walls. */
enum ts_status ts_coincide_foresee(struct ts_instance *self, struct tsim *sim);

#endif
