/* Region: the intersection of other regions. */
#include "particles/region_set.h"

#include <math.h>

#include "base/banned.h"

static bool contains(const struct ts_instance *self, const double x[3])
{
	const struct ts_region_set *u = self->state;

	for (int64_t k = 0; k < u->n; k++)
		if (!ts_region_contains(u->member[k], x))
			return false;
	return true;
}

static double depth(const struct ts_instance *self, const double x[3])
{
	const struct ts_region_set *u = self->state;
	double least = INFINITY;

	for (int64_t k = 0; k < u->n; k++) {
		double one = ts_region_depth(u->member[k], x);

		if (isnan(one))
			return NAN;
		least = fmin(least, one);
	}
	return least;
}

static void bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	const struct ts_region_set *u = self->state;
	double a[3], b[3];

	for (int64_t k = 0; k < u->n; k++) {
		ts_region_bounds(u->member[k], a, b);
		for (int d = 0; d < 3; d++) {
			lo[d] = k ? fmax(lo[d], a[d]) : a[d];
			hi[d] = k ? fmin(hi[d], b[d]) : b[d];
		}
	}
}

TS_STYLE(region, ts_region_style, ts_region_intersect)
const struct ts_region_style ts_region_intersect = {
	.style = {
		.name = "intersect",
		.kind = TS_KIND_REGION,
		.summary = "All points that several regions share",
		.doc = "A point belongs to it if it belongs to all of the n regions; the side of each counts, so\n"
		       "that a region with `side out` cuts a hole.",
		.example = "region ring intersect 2 outer_cylinder not_inner_cylinder",
		.args = ts_region_set_args,
		.state_size = sizeof(struct ts_region_set),
		.init = ts_region_set_init,
	},
	.contains = contains,
	.depth = depth,
	.bounds = bounds,
	.update = ts_region_set_update,
};
