/* Where a sphere touches a triangle of a mesh: in its face, at an edge, or at a corner. */
#ifndef TS_MESH_MESH_TOUCH_H
#define TS_MESH_MESH_TOUCH_H

#include "mesh/mesh.h"

enum ts_mesh_part {
	TS_MESH_NOTHING, /* nearest is an edge or corner that is not active in this triangle */
	TS_MESH_FACE,
	TS_MESH_EDGE,
	TS_MESH_CORNER
};

struct ts_mesh_contact_point {
	double weight[3]; /* of the corners: the point is the sum of weight[k] * corner k */
	double n[3];	  /* unit vector from the point to x; 0 if they coincide */
	double distance;
};

/* A point that is beyond an edge by less than this is taken as on the side where the triangle is, so that
 * between neighbours there is no gap: a small part of the triangle, and what the corners that neighbours
 * share are apart. */
static inline double ts_mesh_tolerance(const struct ts_mesh *mesh, size_t t)
{
	return 1e-9 * mesh->reach[t] + mesh->loose;
}

/* The point of the triangle nearest to x. */
enum ts_mesh_part ts_mesh_nearest(const struct ts_mesh *mesh, size_t t, const double x[3],
				  struct ts_mesh_contact_point *spot);

#endif
