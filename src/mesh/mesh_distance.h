/* How far a place is from a closed mesh, and whether it is inside. */
#ifndef TS_MESH_MESH_DISTANCE_H
#define TS_MESH_MESH_DISTANCE_H

#include "mesh/mesh_tree.h"

struct ts_mesh_distance {
	double distance;  /* < 0 inside */
	double n[3];	  /* unit vector out of the solid, along the way from the surface to the place */
	double weight[3]; /* the nearest point of the triangle: sum of weight[k] * corner k */
	int32_t triangle;
};

/* Weights of the corners for the point of triangle t nearest to x (C. Ericson, Real-Time Collision Detection,
 * 2005, ch. 5.1.5). */
void ts_mesh_nearest_point(const struct ts_mesh *mesh, size_t t, const double x[3], double weight[3]);

/* The distance of x from triangle t. */
double ts_mesh_distance(const struct ts_mesh *mesh, size_t t, const double x[3]);

/* False: the surface is farther than `reach`, and `out` is not written. Of triangles equally near - x is
 * nearest to an edge or a corner - the one seen most from the front decides on which side x is. `list` is
 * scratch. */
enum ts_status ts_mesh_signed_distance(const struct ts_mesh *mesh, const struct ts_mesh_tree *tree,
				       const double x[3], double reach, struct ts_mesh_list *list, bool *near,
				       struct ts_mesh_distance *out);

/* Inside at any distance, from the solid angle under which the triangles are seen, 4 pi or 0 (A. Van Oosterom
 * & J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125). Goes through all triangles. */
bool ts_mesh_inside(const struct ts_mesh *mesh, const double x[3]);

/* Whether each edge belongs to two triangles; else *t is one with an edge that does not. */
bool ts_mesh_closed(const struct ts_mesh *mesh, size_t *t);

#endif
