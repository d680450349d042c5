/* Region: a truncated cone along an axis. */
#include "particles/region.h"

#include "base/banned.h"

struct cone {
	struct ts_region region;
	int axis, c[2];	 /* the axis and the other two dimensions, ascending */
	double given[6]; /* c1 c2 radius_lo radius_hi lo hi as written */
	double center[2], radius[2], lo, hi;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct cone *z = self->state;
	double scale;

	ts_region_init(self, sim);
	scale = z->region.scale;
	z->c[0] = z->axis == 0 ? 1 : 0;
	z->c[1] = z->axis == 2 ? 1 : 2;
	for (int k = 0; k < 2; k++) {
		z->center[k] = scale * z->given[k];
		z->radius[k] = scale * z->given[2 + k];
	}
	z->lo = scale * z->given[4];
	z->hi = scale * z->given[5];
	if (z->lo >= z->hi)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "region cone: lo = %g is not below hi = %g", z->lo, z->hi);
	return TS_OK;
}

static bool contains(const struct ts_instance *self, const double x[3])
{
	const struct cone *z = self->state;
	double a = x[z->c[0]] - z->center[0], b = x[z->c[1]] - z->center[1];
	double along = (x[z->axis] - z->lo) / (z->hi - z->lo);
	double radius = z->radius[0] + along * (z->radius[1] - z->radius[0]);

	return along >= 0 && along <= 1 && a * a + b * b <= radius * radius;
}

static void bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	const struct cone *z = self->state;
	double radius = z->radius[0] > z->radius[1] ? z->radius[0] : z->radius[1];

	for (int k = 0; k < 2; k++) {
		lo[z->c[k]] = z->center[k] - radius;
		hi[z->c[k]] = z->center[k] + radius;
	}
	lo[z->axis] = z->lo;
	hi[z->axis] = z->hi;
}

static const char *const axes[] = { "x", "y", "z", NULL };

static const struct ts_arg args[] = {
	TS_ENUM("axis", struct cone, axis, axes, .flags = TS_POSITIONAL,
		.help = "direction of the axis"),
	TS_REAL("c1", struct cone, given[0], .flags = TS_POSITIONAL, .unit = "length",
		.help = "center in the first of the other dimensions"),
	TS_REAL("c2", struct cone, given[1], .flags = TS_POSITIONAL, .unit = "length",
		.help = "center in the second of the other dimensions"),
	TS_REAL("radius_lo", struct cone, given[2], .flags = TS_POSITIONAL, .unit = "length",
		.range = TS_NOT_NEGATIVE, .help = "radius at the lower end"),
	TS_REAL("radius_hi", struct cone, given[3], .flags = TS_POSITIONAL, .unit = "length",
		.range = TS_NOT_NEGATIVE, .help = "radius at the upper end"),
	TS_REAL("lo", struct cone, given[4], .flags = TS_POSITIONAL, .unit = "length",
		.help = "lower end along the axis"),
	TS_REAL("hi", struct cone, given[5], .flags = TS_POSITIONAL, .unit = "length",
		.help = "upper end along the axis"),
	TS_REGION_ARGS(struct cone),
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_cone)
const struct ts_region_style ts_region_cone = {
	.style = {
		.name = "cone",
		.kind = TS_KIND_REGION,
		.summary = "A truncated cone along an axis",
		.doc = "All points between lo and hi whose distance from the axis is at most a radius that\n"
		       "changes linearly from radius_lo to radius_hi. The center is given in the other two\n"
		       "dimensions, in the order x y z.",
		.example = "region funnel cone z 0 0 0.05 0.25 0 1 units box",
		.args = args,
		.state_size = sizeof(struct cone),
		.init = init,
	},
	.contains = contains,
	.bounds = bounds,
};
