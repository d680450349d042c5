/* Region: a cylinder along an axis. */
#include "particles/region.h"

#include "base/banned.h"

struct cylinder {
	struct ts_region region;
	int axis, c[2]; /* the axis and the other two dimensions, ascending */
	double given_center[2], given_radius, given_lo, given_hi;
	double center[2], radius, lo, hi;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct cylinder *z = self->state;

	ts_region_init(self, sim);
	z->c[0] = z->axis == 0 ? 1 : 0;
	z->c[1] = z->axis == 2 ? 1 : 2;
	z->center[0] = z->region.scale * z->given_center[0];
	z->center[1] = z->region.scale * z->given_center[1];
	z->radius = z->region.scale * z->given_radius;
	z->lo = z->region.scale * z->given_lo;
	z->hi = z->region.scale * z->given_hi;
	if (z->lo > z->hi)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "region cylinder: lo = %g is above hi = %g", z->lo, z->hi);
	return TS_OK;
}

static bool contains(const struct ts_instance *self, const double x[3])
{
	const struct cylinder *z = self->state;
	double a = x[z->c[0]] - z->center[0], b = x[z->c[1]] - z->center[1];

	return a * a + b * b <= z->radius * z->radius && x[z->axis] >= z->lo && x[z->axis] <= z->hi;
}

static void bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	const struct cylinder *z = self->state;

	for (int k = 0; k < 2; k++) {
		lo[z->c[k]] = z->center[k] - z->radius;
		hi[z->c[k]] = z->center[k] + z->radius;
	}
	lo[z->axis] = z->lo;
	hi[z->axis] = z->hi;
}

static const char *const axes[] = { "x", "y", "z", NULL };

static const struct ts_arg args[] = {
	TS_ENUM("axis", struct cylinder, axis, axes, .flags = TS_POSITIONAL,
		.help = "direction of the axis"),
	TS_REAL("c1", struct cylinder, given_center[0], .flags = TS_POSITIONAL, .unit = "length",
		.help = "center in the first of the other dimensions"),
	TS_REAL("c2", struct cylinder, given_center[1], .flags = TS_POSITIONAL, .unit = "length",
		.help = "center in the second of the other dimensions"),
	TS_REAL("radius", struct cylinder, given_radius, .flags = TS_POSITIONAL, .unit = "length",
		.range = TS_NOT_NEGATIVE, .help = "radius"),
	TS_COORD("lo", struct cylinder, given_lo, .flags = TS_POSITIONAL, .unit = "length",
		 .help = "lower end along the axis, or INF"),
	TS_COORD("hi", struct cylinder, given_hi, .flags = TS_POSITIONAL, .unit = "length",
		 .help = "upper end along the axis, or INF"),
	TS_REGION_ARGS(struct cylinder),
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_cylinder)
const struct ts_region_style ts_region_cylinder = {
	.style = {
		.name = "cylinder",
		.kind = TS_KIND_REGION,
		.summary = "A cylinder along an axis",
		.doc = "All points within the radius of the axis, between lo and hi. The center is given\n"
		       "in the other two dimensions, in the order x y z: (y, z) for axis x, (x, z) for\n"
		       "axis y, (x, y) for axis z.",
		.example = "region hole cylinder z 0 0 0.25 0 1 units box\n"
			   "region outside cylinder z 0 0 0.25 INF INF side out units box",
		.args = args,
		.state_size = sizeof(struct cylinder),
		.init = init,
	},
	.contains = contains,
	.bounds = bounds,
};
