/* Cracks: open edges that come close to an end of another open edge without sharing this vertex. */
#ifndef TS_MESH_MESH_CRACKS_H
#define TS_MESH_MESH_CRACKS_H

#include "mesh/mesh.h"

/* Edge k of a triangle; lo < hi: its vertices. */
struct ts_mesh_edge {
	int32_t lo, hi, triangle, k;
};

/* Called for each crack: `triangle` has a corner at the position `at`, at the distance `width` from an
 * edge of `other`. */
typedef enum ts_status ts_mesh_crack_fn(void *context, int32_t triangle, int32_t other, const double at[3],
					double width);

/* Finds the cracks. `edge`: the n edges of all triangles, sorted by their vertices; those that occur once are
 * open. A crack is narrower than 1/1000 of the edge along which it runs. */
enum ts_status ts_mesh_cracks(const struct ts_mesh *mesh, const struct ts_mesh_edge *edge, size_t n,
			      ts_mesh_crack_fn *found, void *context);

#endif
