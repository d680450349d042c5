/* Forces of a mesh wall: finds the listed pairs that touch, and transfers contacts from triangle to
 * triangle. */
#ifndef TS_WALL_MESH_WALL_QUEUE_H
#define TS_WALL_MESH_WALL_QUEUE_H

#include "wall/mesh_wall.h"

/* Computes all forces of the step; fails if the centre of a particle lies in the surface. */
enum ts_status ts_mesh_wall_enqueue_contacts(struct tsim *sim, struct ts_wall *w, struct ts_mesh_wall *mw);

#endif
