/* The triangles around points that are near each other: the tree is searched once for all of them, and each point is
 * compared with eight triangles at a time. */
#ifndef TS_MESH_MESH_VICINITY_H
#define TS_MESH_MESH_VICINITY_H

#include "mesh/mesh_tree.h"

enum { TS_MESH_LANES = 8 };

/* Bounding boxes, first corners and normals of some triangles, in columns. */
struct ts_mesh_lanes {
	double lo[3][TS_MESH_LANES], hi[3][TS_MESH_LANES], corner[3][TS_MESH_LANES], normal[3][TS_MESH_LANES];
};

/* Result of a search. Zero-initialise, release by ts_mesh_vicinity_release. */
struct ts_mesh_vicinity {
	double lo[3], hi[3], distance; /* valid for points in this box and up to this distance */
	struct ts_mesh_list candidate; /* triangles that may be near enough, in ascending order */
	struct ts_mesh_lanes *lanes;   /* of these */
	size_t lanes_capacity;
};
void ts_mesh_vicinity_release(struct ts_mesh_vicinity *vicinity);

/* Largest edge of the box of a vicinity, in units of the search distance: a larger one has more triangles to compare, a
 * smaller one serves fewer points. */
#define TS_MESH_VICINITY 8.0

/* Makes a vicinity for the points of the box lo .. hi and distances up to `distance`. */
enum ts_status ts_mesh_vicinity_make(const struct ts_mesh_tree *tree, const struct ts_mesh *mesh,
				     const double lo[3], const double hi[3], double distance,
				     struct ts_mesh_vicinity *vicinity);
/* The same list as that of ts_mesh_tree_near. A vicinity that is not valid for the point is made anew. */
enum ts_status ts_mesh_vicinity_near(const struct ts_mesh_tree *tree, const struct ts_mesh *mesh,
				     const double x[3], double distance, struct ts_mesh_vicinity *vicinity,
				     struct ts_mesh_list *list);

#endif
