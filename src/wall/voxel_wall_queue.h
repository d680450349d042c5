/* Forces of a wall made of a height field: finds the contact points and matches them to the contacts. */
#ifndef TS_WALL_VOXEL_WALL_QUEUE_H
#define TS_WALL_VOXEL_WALL_QUEUE_H

#include "wall/voxel_wall.h"

/* The slot `enqueue` of struct ts_wall_shape. */
enum ts_status ts_voxel_wall_enqueue_contacts(struct ts_instance *self, struct tsim *sim);

#endif
