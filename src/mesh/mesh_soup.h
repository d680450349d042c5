/* Selection and transformation of the triangles of a file before a mesh is built of them. */
#ifndef TS_MESH_MESH_SOUP_H
#define TS_MESH_MESH_SOUP_H

#include "mesh/mesh_load.h"
#include "geom/triangles.h"

/* Removes triangles outside of `region`, in the coordinates of the file, and those of
 * element_exclusion_list. */
enum ts_status ts_mesh_soup_choose(struct ts_instance *self, struct tsim *sim,
				   const struct ts_mesh_words *words, struct ts_triangles *soup);
/* Instead of a file: the faces swept by the outer edges of a planar mesh when they are translated by its
 * `extrusion` against the normal; their normals point outwards. Motions of that mesh are not included. */
enum ts_status ts_mesh_soup_extrude(struct ts_instance *self, struct tsim *sim, const struct ts_word *id,
				    struct ts_triangles *soup);
/* Applies the keywords scale, move and rotate in the order of the line. */
enum ts_status ts_mesh_soup_transform(struct ts_instance *self, struct tsim *sim, struct ts_triangles *soup);

#endif
