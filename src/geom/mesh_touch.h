/* Where a sphere touches a triangle of a mesh: in its face, at an edge, or at a corner. */
#ifndef TS_GEOM_MESH_TOUCH_H
#define TS_GEOM_MESH_TOUCH_H

#include "geom/mesh.h"

enum ts_mesh_part {
	TS_MESH_NOTHING, /* nearest is an edge or corner that is not active in this triangle */
	TS_MESH_FACE,
	TS_MESH_EDGE,
	TS_MESH_CORNER
};

struct ts_mesh_spot {
	double weight[3]; /* of the corners: the point is the sum of weight[k] * corner k */
	double n[3];	  /* unit vector from the point to x; 0 if they coincide */
	double distance;
};

/* The point of the triangle nearest to x. */
enum ts_mesh_part ts_mesh_nearest(const struct ts_mesh *mesh, size_t t, const double x[3],
				  struct ts_mesh_spot *spot);

#endif
