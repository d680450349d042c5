/* Triangles of a file on their way to a mesh: which of them, and where. */
#ifndef TS_MESH_MESH_SOUP_H
#define TS_MESH_MESH_SOUP_H

#include "mesh/mesh_load.h"
#include "mesh/triangles.h"

/* Drops those outside of `region`, where the file has them, and those of element_exclusion_list. */
enum ts_status ts_mesh_soup_choose(struct ts_instance *self, struct tsim *sim,
				   const struct ts_mesh_words *words, struct ts_triangles *soup);
/* Instead of a file: the faces that the outer edges of a plane mesh sweep when they are moved by its
 * `extrusion` against the normal, seen from outside. Where the mesh has been moved, as it was before. */
enum ts_status ts_mesh_soup_extrude(struct ts_instance *self, struct tsim *sim, const struct ts_word *id,
				    struct ts_triangles *soup);
/* scale, move and rotate in the order they are written. */
enum ts_status ts_mesh_soup_transform(struct ts_instance *self, struct tsim *sim, struct ts_triangles *soup);

#endif
