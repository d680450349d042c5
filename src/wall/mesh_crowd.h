/* Contacts of a particle with several triangles within one contact area. On a curved surface whose triangles are smaller than
 * the contact area, and not flat to `curvature`, each of them has the force of a plane: the sum is several times too large. */
#ifndef TS_WALL_MESH_CROWD_H
#define TS_WALL_MESH_CROWD_H

#include "wall/mesh_wall.h"

/* So many are told; two are those of a particle beside an edge (fix mesh/surface). */
enum { TS_MESH_CROWD = 3 };

/* Notes particle `v`, which touches TS_MESH_CROWD triangles or more, if so many of its contacts are within one contact
 * area, with triangles that are no larger than it, and overlap more than twice as much together as the deepest of them.
 * By any thread. */
void ts_mesh_crowd_look(const struct tsim *sim, struct ts_mesh_wall *mw, const struct ts_mesh_neighbor *v);
/* Warns, once for each wall, of the particle with the lowest identity of those noted in this step. */
void ts_mesh_crowd_tell(const struct ts_instance *self, struct tsim *sim, struct ts_mesh_wall *mw);

#endif
