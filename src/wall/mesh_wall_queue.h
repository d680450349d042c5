/* Forces of a wall of meshes: which of the listed contacts touch, and how one goes on from triangle to
 * triangle. */
#ifndef TS_WALL_MESH_WALL_QUEUE_H
#define TS_WALL_MESH_WALL_QUEUE_H

#include "wall/mesh_wall.h"

/* All forces of the step; refuses a particle whose centre lies in the surface. */
enum ts_status ts_mesh_wall_enqueue_contacts(struct tsim *sim, struct ts_wall *w, struct ts_mesh_wall *mw);

#endif
