/* Cracks: open edges that nearly touch a corner of another open edge, without sharing it. */
#ifndef TS_MESH_MESH_CRACKS_H
#define TS_MESH_MESH_CRACKS_H

#include "mesh/mesh.h"

/* Edge k of a triangle, known by its vertices. */
struct ts_mesh_edge {
	int32_t lo, hi, triangle, k;
};

/* A crack: the triangle has a corner at distance `width` of an edge of the other. */
typedef enum ts_status ts_mesh_crack_fn(void *context, int32_t triangle, int32_t other, const double at[3],
					double width);

/* The edges come sorted by their vertices; those that are there once are open. A crack is narrower than a
 * thousandth of the edge it runs along. */
enum ts_status ts_mesh_cracks(const struct ts_mesh *mesh, const struct ts_mesh_edge *edge, size_t n,
			      ts_mesh_crack_fn *found, void *context);

#endif
