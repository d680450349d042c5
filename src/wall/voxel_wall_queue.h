/* Forces of a wall made of a height field: finds the contact points and matches them to the contacts. */
#ifndef TS_WALL_VOXEL_WALL_QUEUE_H
#define TS_WALL_VOXEL_WALL_QUEUE_H

#include "wall/voxel_wall.h"

/* Computes all forces of the step; fails if the centre of a particle lies in the solid. */
enum ts_status ts_voxel_wall_enqueue_contacts(struct ts_instance *self, struct tsim *sim, struct ts_wall *w,
					      struct ts_voxel_wall *vw);

#endif
