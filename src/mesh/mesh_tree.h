/* Search for the triangles of a mesh near a point: a binary tree of bounding boxes over the triangles, sorted
 * along a space-filling curve (G. M. Morton, IBM report, 1966). A search takes about O(log n) steps for any
 * distribution of triangle sizes. */
#ifndef TS_MESH_MESH_TREE_H
#define TS_MESH_MESH_TREE_H

#include "mesh/mesh.h"

enum { TS_MESH_TREE_STACK = 64 }; /* twice the depth of a tree is less */

struct ts_mesh_tree {
	size_t n, leaves;	   /* number of triangles; of leaves, a power of two */
	int32_t *triangle;	   /* [n], in the order of the curve */
	double (*lo)[3], (*hi)[3]; /* bounding boxes, [2 leaves]; root 1, children of node k: 2k and 2k + 1 */
};

/* The tree must be zero or released before. On failure, TS_NOMEM, it is released. */
enum ts_status ts_mesh_tree_build(struct ts_mesh_tree *tree, const struct ts_mesh *mesh);
void ts_mesh_tree_release(struct ts_mesh_tree *tree);

/* A list of triangles; zero-initialise, release by ts_free(list.item). */
struct ts_mesh_list {
	size_t n, capacity;
	int32_t *item;
};
/* All triangles that may have a point nearer to x than `distance`, in ascending order. */
enum ts_status ts_mesh_tree_near(const struct ts_mesh_tree *tree, const struct ts_mesh *mesh,
				 const double x[3], double distance, struct ts_mesh_list *list);

/* Triangles one after the other, those in nearer boxes first, for the search of the nearest one:
 *   for (ts_mesh_tree_descend(&d, tree, x); ts_mesh_tree_next(&d, least, &t);) least = ...; */
struct ts_mesh_descent {
	const struct ts_mesh_tree *tree;
	const double *x;
	size_t stack[TS_MESH_TREE_STACK], depth, at, end; /* nodes to visit; triangles left of a leaf */
};
void ts_mesh_tree_descend(struct ts_mesh_descent *d, const struct ts_mesh_tree *tree, const double x[3]);
/* The next triangle whose box is not farther from x than `least`; false: there is none. */
bool ts_mesh_tree_next(struct ts_mesh_descent *d, double least, size_t *t);

/* All triangles whose bounding boxes overlap the box lo .. hi, in ascending order. */
enum ts_status ts_mesh_tree_within(const struct ts_mesh_tree *tree, const struct ts_mesh *mesh,
				   const double lo[3], const double hi[3], struct ts_mesh_list *list);

#endif
