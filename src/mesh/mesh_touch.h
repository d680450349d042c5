/* Contact point of a sphere and a triangle of a mesh: in its face, on an edge, or at a corner. */
#ifndef TS_MESH_MESH_TOUCH_H
#define TS_MESH_MESH_TOUCH_H

#include "mesh/mesh.h"

enum ts_mesh_part {
	TS_MESH_NOTHING, /* the nearest point is on an edge or corner that is not active in this triangle */
	TS_MESH_FACE,
	TS_MESH_EDGE,
	TS_MESH_CORNER
};

struct ts_mesh_contact_point {
	double weight[3]; /* barycentric coordinates: the point is the sum of weight[k] * corner k */
	double n[3];	  /* unit vector from the point to x; 0 if they coincide */
	double distance;  /* of the point from x, length */
};

/* Tolerance, length: a point that is beyond an edge by less than this counts as inside, so that there is
 * no gap between neighbours. It covers rounding, relative to the size of the triangle, and the distance of
 * corners that neighbours share. */
static inline double ts_mesh_tolerance(const struct ts_mesh *mesh, size_t t)
{
	return 1e-9 * mesh->reach[t] + mesh->loose;
}

/* The point of triangle t nearest to x, and the part of the triangle in which it is. */
enum ts_mesh_part ts_mesh_nearest(const struct ts_mesh *mesh, size_t t, const double x[3],
				  struct ts_mesh_contact_point *point);

#endif
