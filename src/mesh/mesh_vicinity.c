#include "base/clones.h"
TS_UNROLLED

#include "mesh/mesh_vicinity.h"

#include <math.h>

#include "base/alloc.h"

#include "base/banned.h"

void ts_mesh_vicinity_release(struct ts_mesh_vicinity *v)
{
	ts_free(v->candidate.item);
	ts_free(v->lanes);
	*v = (struct ts_mesh_vicinity){ 0 };
}

static void set_lane(struct ts_mesh_lanes *lanes, size_t j, const double corner[3][3], const double normal[3])
{
	for (int d = 0; d < 3; d++) {
		lanes->lo[d][j] = INFINITY;
		lanes->hi[d][j] = -INFINITY;
		for (int k = 0; k < 3; k++) {
			lanes->lo[d][j] = corner[k][d] < lanes->lo[d][j] ? corner[k][d] : lanes->lo[d][j];
			lanes->hi[d][j] = corner[k][d] > lanes->hi[d][j] ? corner[k][d] : lanes->hi[d][j];
		}
		lanes->corner[d][j] = corner[0][d];
		lanes->normal[d][j] = normal[d];
	}
}

/* Nothing is near to a lane without a triangle. */
static void clear_lane(struct ts_mesh_lanes *lanes, size_t j)
{
	for (int d = 0; d < 3; d++) {
		lanes->lo[d][j] = INFINITY;
		lanes->hi[d][j] = -INFINITY;
		lanes->corner[d][j] = lanes->normal[d][j] = 0;
	}
}

enum ts_status ts_mesh_vicinity_make(const struct ts_mesh_tree *tree, const struct ts_mesh *m,
				     const double lo[3], const double hi[3], double distance,
				     struct ts_mesh_vicinity *v)
{
	double from[3], to[3];
	size_t blocks;

	v->distance = distance;
	for (int d = 0; d < 3; d++) {
		v->lo[d] = lo[d];
		v->hi[d] = hi[d];
		/* wider by the rounding of the comparisons in find_near */
		from[d] = lo[d] - distance - 1e-15 * (fabs(lo[d]) + distance);
		to[d] = hi[d] + distance + 1e-15 * (fabs(hi[d]) + distance);
	}
	TS_TRY(ts_mesh_tree_within(tree, m, from, to, &v->candidate));
	blocks = (v->candidate.n + TS_MESH_LANES - 1) / TS_MESH_LANES;
	TS_TRY(TS_GROW(v->lanes, v->lanes_capacity, blocks));
	TS_TRY(TS_GROW(v->candidate.item, v->candidate.capacity, blocks * TS_MESH_LANES));
	for (size_t k = 0; k < blocks * TS_MESH_LANES; k++) {
		struct ts_mesh_lanes *lanes = &v->lanes[k / TS_MESH_LANES];
		size_t t = k < v->candidate.n ? (size_t)v->candidate.item[k] : 0;

		if (k < v->candidate.n)
			set_lane(lanes, k % TS_MESH_LANES, (const double(*)[3])m->x[t], m->normal[t]);
		else
			clear_lane(lanes, k % TS_MESH_LANES);
	}
	return TS_OK;
}

/* Copies the triangles of which neither the bounding box nor the plane is farther from x than `distance`; returns their
 * number. `item` and `out` have room for whole blocks of lanes. */
TS_CLONES static size_t find_near(const struct ts_mesh_lanes *lanes, size_t blocks, const int32_t *item,
				  const double x[3], double distance, int32_t *out)
{
	const double plane = distance * (1 + 1e-9);
	size_t n = 0;

	for (size_t b = 0; b < blocks; b++) {
		const struct ts_mesh_lanes *at = &lanes[b];
		int64_t near[TS_MESH_LANES];

#pragma omp simd
		for (int j = 0; j < TS_MESH_LANES; j++) {
			double height = (x[0] - at->corner[0][j]) * at->normal[0][j] +
					(x[1] - at->corner[1][j]) * at->normal[1][j] +
					(x[2] - at->corner[2][j]) * at->normal[2][j];

			near[j] = (fabs(height) <= plane) & (at->lo[0][j] - distance <= x[0]) &
				  (x[0] <= at->hi[0][j] + distance) & (at->lo[1][j] - distance <= x[1]) &
				  (x[1] <= at->hi[1][j] + distance) & (at->lo[2][j] - distance <= x[2]) &
				  (x[2] <= at->hi[2][j] + distance);
		}
		for (int j = 0; j < TS_MESH_LANES; j++) {
			out[n] = item[b * TS_MESH_LANES + (size_t)j];
			n += (size_t)near[j];
		}
	}
	return n;
}

static bool is_valid(const struct ts_mesh_vicinity *v, const double x[3], double distance)
{
	bool is = distance <= v->distance;

	for (int d = 0; d < 3; d++)
		is &= v->lo[d] <= x[d] && x[d] <= v->hi[d];
	return is;
}

enum ts_status ts_mesh_vicinity_near(const struct ts_mesh_tree *tree, const struct ts_mesh *m,
				     const double x[3], double distance, struct ts_mesh_vicinity *v,
				     struct ts_mesh_list *list)
{
	double lo[3], hi[3];
	size_t blocks;

	for (int d = 0; d < 3; d++) {
		lo[d] = x[d] - 0.5 * TS_MESH_VICINITY * distance;
		hi[d] = x[d] + 0.5 * TS_MESH_VICINITY * distance;
	}
	if (!is_valid(v, x, distance))
		TS_TRY(ts_mesh_vicinity_make(tree, m, lo, hi, distance, v));
	blocks = (v->candidate.n + TS_MESH_LANES - 1) / TS_MESH_LANES;
	TS_TRY(TS_GROW(list->item, list->capacity, blocks * TS_MESH_LANES + 1));
	list->n = find_near(v->lanes, blocks, v->candidate.item, x, distance, list->item);
	return TS_OK;
}
