/* Signed distance of a point from a closed mesh, and whether it is inside. */
#ifndef TS_MESH_MESH_DISTANCE_H
#define TS_MESH_MESH_DISTANCE_H

#include "mesh/mesh_tree.h"

struct ts_mesh_distance {
	double distance; /* length, < 0 inside */
	double n[3]; /* unit vector out of the solid, along the line through the point and the nearest one */
	double weight[3]; /* barycentric coordinates of the nearest point: sum of weight[k] * corner k */
	int32_t triangle; /* of the nearest point */
};

/* Barycentric coordinates of the point of triangle t nearest to x (C. Ericson, Real-Time Collision Detection,
 * 2005, ch. 5.1.5). */
void ts_mesh_nearest_point(const struct ts_mesh *mesh, size_t t, const double x[3], double weight[3]);

/* The distance of x from triangle t. */
double ts_mesh_distance(const struct ts_mesh *mesh, size_t t, const double x[3]);
/* The distance of x from the nearest of all triangles; INFINITY for a mesh without any. */
double ts_mesh_distance_least(const struct ts_mesh *mesh, const struct ts_mesh_tree *tree, const double x[3]);

/* Signed distance of x from the surface. *near false: the surface is farther than `reach`, and `out` is not
 * written. If several triangles are equally near, as x is nearest to an edge or corner, the triangle
 * whose plane is most nearly perpendicular to the line to x gives the sign. `list`: buffer. */
enum ts_status ts_mesh_signed_distance(const struct ts_mesh *mesh, const struct ts_mesh_tree *tree,
				       const double x[3], double reach, struct ts_mesh_list *list, bool *near,
				       struct ts_mesh_distance *out);

/* Whether x is inside, at any distance: by the total solid angle of the triangles seen from x, +-4 pi or 0
 * (A. Van Oosterom & J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125). O(n). */
bool ts_mesh_inside(const struct ts_mesh *mesh, const double x[3]);

/* Whether each edge is shared by exactly two triangles; else *t is a triangle with an edge that is not. */
bool ts_mesh_closed(const struct ts_mesh *mesh, size_t *t);

#endif
