/* Which triangles of a mesh are near a place: a binary tree of boxes over the triangles in the order of
 * a space-filling curve (G. M. Morton, IBM report, 1966). A question costs about the logarithm of their
 * number, however large or small triangles are. */
#ifndef TS_MESH_MESH_TREE_H
#define TS_MESH_MESH_TREE_H

#include "mesh/mesh.h"

struct ts_mesh_tree {
	size_t n, leaves;	   /* leaves: a power of two */
	int32_t *triangle;	   /* in the order of the curve */
	double (*lo)[3], (*hi)[3]; /* boxes; node k has the children 2k and 2k + 1, from node 1 on */
};

/* Zero-initialise or release before. TS_NOMEM: it is released. */
enum ts_status ts_mesh_tree_build(struct ts_mesh_tree *tree, const struct ts_mesh *mesh);
void ts_mesh_tree_release(struct ts_mesh_tree *tree);

/* A list that grows; zero-initialise, ts_free the item. */
struct ts_mesh_list {
	size_t n, capacity;
	int32_t *item;
};
/* All triangles that may have a point nearer to x than `distance`, in ascending order. */
enum ts_status ts_mesh_tree_near(const struct ts_mesh_tree *tree, const struct ts_mesh *mesh,
				 const double x[3], double distance, struct ts_mesh_list *list);

/* What has been found for a place, for others near it. Zero-initialise, ts_free the items of leaf. */
struct ts_mesh_vicinity {
	double lo[3], hi[3], distance; /* for places in this box, and for less than this distance */
	struct ts_mesh_list leaf;      /* these nodes may be near enough */
};
/* The same as ts_mesh_tree_near, quicker for one place after the other if these are near each other. */
enum ts_status ts_mesh_tree_near_again(const struct ts_mesh_tree *tree, const struct ts_mesh *mesh,
				       const double x[3], double distance, struct ts_mesh_vicinity *vicinity,
				       struct ts_mesh_list *list);

#endif
