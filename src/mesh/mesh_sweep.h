/* When a sphere that moves along a straight line first touches a mesh: the faces, edges and corners of its triangles. */
#ifndef TS_MESH_MESH_SWEEP_H
#define TS_MESH_MESH_SWEEP_H

#include "geom/sweep.h"
#include "mesh/mesh_tree.h"

struct ts_mesh_hit {
	struct ts_sweep_hit hit;
	int32_t triangle;
	int part; /* enum ts_mesh_part; of several touched at once the face, of several faces the first */
};

/* *found: whether something is touched. `list`: buffer. */
enum ts_status ts_mesh_sweep(const struct ts_mesh *mesh, const struct ts_mesh_tree *tree,
			     const struct ts_sweep *path, struct ts_mesh_list *list, bool *found,
			     struct ts_mesh_hit *out);

#endif
