/* Triangle meshes: flat triangles in space that may share edges and corners.
 *
 * Triangles are numbered from 0 in the order they were given. Edge k of a triangle goes from its corner
 * k to corner k + 1 (mod 3). Seen from the side to which the normal points, the corners are in anticlockwise
 * order.
 *
 * A particle that slides over a mesh must not feel an edge between triangles where the surface is flat, and
 * must have one contact with an edge or corner, not one for each triangle that shares it. So each edge and
 * corner is active in at most one triangle:
 *   edge    between two flat neighbours: in none; else in the last of the triangles that share it
 *   corner  in the last of the triangles around it, unless no edge that ends there is active, or two
 *           of these edges are collinear
 * Two triangles are flat neighbours if the angle between their planes is less than `curvature`. Where they bulge, spheres above
 * an edge or corner that is not active touch the last of the triangles there: mesh_touch.c. */
#ifndef TS_MESH_MESH_H
#define TS_MESH_MESH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"
#include "geom/box.h"

struct ts_mesh {
	size_t n; /* triangles */

	/* Geometry, [n]. After a change of x call ts_mesh_update_geometry. */
	double (*x)[3][3];     /* corners, [triangle][corner][dimension], length */
	double (*normal)[3];   /* unit vector; 0 for a triangle without area */
	double (*along)[3][3]; /* unit vectors along the edges */
	double (*length)[3];   /* of the edges */
	double *area;
	double (*centre)[3]; /* mean of the corners */
	double *reach;	     /* distance from the centre to the farthest corner */

	/* Topology, [n]: does not change when the mesh moves. */
	size_t nvertices;
	int32_t (
		*vertex)[3]; /* vertices of the corners, 0 .. nvertices-1; coincident corners have the same */
	int32_t (*neighbour)[3]; /* the only other triangle that shares edge k; -1: none;
				  * TS_MESH_MANY: several */
	uint8_t *active;	 /* bit k: edge k is active, bit 3 + k: corner k is active; TS_MESH_REMOVED */
	double flat;		 /* cosine of the angle `curvature` */
	/* upper bound of the distance of corners with the same vertex, including rounding, length */
	double loose;
	bool legacy; /* ts_mesh_nearest treats points beyond an obtuse corner as LIGGGHTS does */
};

enum { TS_MESH_MANY = -2 };
/* Bit of `active`: the triangle is worn through and has been removed. Its number and neighbours remain, but nothing
 * touches it, and its neighbours have a rim there. */
enum { TS_MESH_REMOVED = 1 << 6 };

static inline bool ts_mesh_is_removed(const struct ts_mesh *mesh, size_t t)
{
	return mesh->active[t] & TS_MESH_REMOVED;
}

static inline bool ts_mesh_edge_active(const struct ts_mesh *mesh, size_t t, int k)
{
	return mesh->active[t] >> k & 1;
}

static inline bool ts_mesh_corner_active(const struct ts_mesh *mesh, size_t t, int k)
{
	return mesh->active[t] >> (3 + k) & 1;
}

/* Builds a mesh of n triangles given by their corners. `precision`: corners nearer to each other than this
 * length are the same; `curvature` in degrees. The mesh must be zero or released before; on failure (no
 * memory, or TS_RANGE: more than INT32_MAX / 64 triangles) it is released. */
enum ts_status ts_mesh_build(struct ts_mesh *mesh, const double (*soup)[3][3], size_t n, double precision,
			     double curvature);
/* Connects triangles across periodic faces of the box: corners that differ by lengths of the box become the
 * same vertex. */
enum ts_status ts_mesh_link_images(struct ts_mesh *mesh, const struct ts_box *box, double precision);
void ts_mesh_release(struct ts_mesh *mesh);

/* After a change of the corners: recomputes normals, edges, areas and centres. */
void ts_mesh_update_geometry(struct ts_mesh *mesh);
/* The same for triangles from .. to-1 only. */
void ts_mesh_update_triangles(struct ts_mesh *mesh, size_t from, size_t to);

/* Whether two triangles share a corner and the angle between their planes is less than `curvature`. */
bool ts_mesh_flat_neighbours(const struct ts_mesh *mesh, size_t a, size_t b);

/* Whether all triangles that share an edge are flat neighbours; else *corner is 3 t + k for an edge k of
 * triangle t at which the surface is not flat. */
bool ts_mesh_planar(const struct ts_mesh *mesh, size_t *corner);

/* Bounding box of all triangles; lo > hi for a mesh without triangles. */
void ts_mesh_bounds(const struct ts_mesh *mesh, double lo[3], double hi[3]);
double ts_mesh_area(const struct ts_mesh *mesh);

#endif
