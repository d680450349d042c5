/* Triangle meshes: flat triangles in space that may share edges and corners.
 *
 * Triangles are numbered from 0 in the order they were given. Edge k of a triangle goes from its corner
 * k to corner k + 1 (mod 3). Seen from where the normal points to, the corners go round anticlockwise.
 *
 * A particle that slides over a mesh must not feel where triangles meet if the surface is flat there, and
 * must feel an edge or corner once, not once for each triangle that has it. So every edge and corner is
 * active in one triangle at most:
 *   edge    between two flat neighbours: in none; else in the last of the triangles that share it
 *   corner  in the last of the triangles around it, unless no edge that meets there is active, or two
 *           of them go on straight
 * Two triangles are flat neighbours if their planes include less than the angle `curvature`. */
#ifndef TS_MESH_MESH_H
#define TS_MESH_MESH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"
#include "geom/box.h"

struct ts_mesh {
	size_t n; /* triangles */

	/* The shape. Who changes x calls ts_mesh_moved. */
	double (*x)[3][3];     /* [triangle][corner][dimension] */
	double (*normal)[3];   /* unit vector; 0 for a triangle without area */
	double (*along)[3][3]; /* unit vectors along the edges */
	double (*length)[3];   /* of the edges */
	double *area;
	double (*centre)[3]; /* mean of the corners */
	double *reach;	     /* from the centre to the furthest corner */

	/* How triangles hang together: stays when the mesh moves. */
	size_t nvertices;
	int32_t (*vertex)[3];	 /* corners at the same place have the same number, 0..nvertices-1 */
	int32_t (*neighbour)[3]; /* across edge k: the only other triangle that has it; -1: none;
				  * TS_MESH_MANY: several */
	uint8_t *active;	 /* bit k: edge k, bit 3 + k: corner k */
	double flat;		 /* cosine of the angle `curvature` */
	/* corners of the same number are no farther apart than this; with rounding */
	double loose;
	bool legacy; /* beyond an obtuse corner as in LIGGGHTS: ts_mesh_nearest */
};

enum { TS_MESH_MANY = -2 };

static inline bool ts_mesh_edge_active(const struct ts_mesh *mesh, size_t t, int k)
{
	return mesh->active[t] >> k & 1;
}

static inline bool ts_mesh_corner_active(const struct ts_mesh *mesh, size_t t, int k)
{
	return mesh->active[t] >> (3 + k) & 1;
}

/* Makes a mesh of n triangles given by their corners. `precision`: corners nearer to each other than this
 * are the same; `curvature` in degrees. The mesh must be zero or released before; on failure (no
 * memory, more than INT32_MAX / 64 triangles: TS_RANGE) it is released. */
enum ts_status ts_mesh_build(struct ts_mesh *mesh, const double (*soup)[3][3], size_t n, double precision,
			     double curvature);
/* Across periodic faces of the box triangles hang together with images of others: corners that differ by
 * lengths of the box become the same. */
enum ts_status ts_mesh_link_images(struct ts_mesh *mesh, const struct ts_box *box, double precision);
void ts_mesh_release(struct ts_mesh *mesh);

/* The corners have changed: normals, edges, areas, centres anew. */
void ts_mesh_moved(struct ts_mesh *mesh);
/* The same for triangles from .. to-1 only. */
void ts_mesh_triangles_moved(struct ts_mesh *mesh, size_t from, size_t to);

/* Whether two triangles share a corner and are flat neighbours. */
bool ts_mesh_flat_neighbours(const struct ts_mesh *mesh, size_t a, size_t b);

/* Whether all triangles that share an edge are flat neighbours; else *corner is 3 t + k of an edge k where
 * the surface bends. */
bool ts_mesh_planar(const struct ts_mesh *mesh, size_t *corner);

/* Box around all triangles; lo > hi for a mesh of none. */
void ts_mesh_bounds(const struct ts_mesh *mesh, double lo[3], double hi[3]);
double ts_mesh_area(const struct ts_mesh *mesh);

#endif
