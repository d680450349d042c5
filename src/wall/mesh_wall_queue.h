/* Forces of a mesh wall: finds the listed pairs that touch, and transfers contacts from triangle to
 * triangle. */
#ifndef TS_WALL_MESH_WALL_QUEUE_H
#define TS_WALL_MESH_WALL_QUEUE_H

#include "wall/mesh_wall.h"

/* The slot `enqueue` of struct ts_wall_shape. */
enum ts_status ts_mesh_wall_enqueue_contacts(struct ts_instance *self, struct tsim *sim);

#endif
