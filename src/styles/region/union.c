/* Region: the union of other regions. */
#include "particles/region_set.h"

#include <math.h>

#include "base/banned.h"

static bool contains(const struct ts_instance *self, const double x[3])
{
	const struct ts_region_set *u = self->state;

	for (int64_t k = 0; k < u->n; k++)
		if (ts_region_contains(u->member[k], x))
			return true;
	return false;
}

static double depth(const struct ts_instance *self, const double x[3])
{
	const struct ts_region_set *u = self->state;
	double most = -INFINITY;

	for (int64_t k = 0; k < u->n; k++) {
		double one = ts_region_depth(u->member[k], x);

		if (isnan(one))
			return NAN;
		most = fmax(most, one);
	}
	return most;
}

static void bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	const struct ts_region_set *u = self->state;
	double a[3], b[3];

	for (int64_t k = 0; k < u->n; k++) {
		ts_region_bounds(u->member[k], a, b);
		for (int d = 0; d < 3; d++) {
			lo[d] = k ? fmin(lo[d], a[d]) : a[d];
			hi[d] = k ? fmax(hi[d], b[d]) : b[d];
		}
	}
}

TS_STYLE(region, ts_region_style, ts_region_union)
const struct ts_region_style ts_region_union = {
	.style = {
		.name = "union",
		.kind = TS_KIND_REGION,
		.summary = "All points of any of several regions",
		.doc = "A point belongs to it if it belongs to at least one of the n regions; the side of each\n"
		       "counts.",
		.example = "region both union 2 left right",
		.args = ts_region_set_args,
		.state_size = sizeof(struct ts_region_set),
		.init = ts_region_set_init,
	},
	.contains = contains,
	.depth = depth,
	.bounds = bounds,
	.update = ts_region_set_update,
};
