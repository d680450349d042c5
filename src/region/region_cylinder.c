/* Region cylinder: a cylinder along a coordinate axis. */
#include "base/axes.h"
#include "math/constants.h"
#include "region/region_frustum.h"

#include "base/banned.h"

struct cylinder {
	struct ts_region region;
	int axis, c[2];		   /* dimension of the axis; the other two, ascending */
	struct ts_number given[3]; /* center (2), radius */
	double given_lo, given_hi;
	double center[2], radius, lo, hi;
};

static enum ts_status update(struct ts_instance *self, struct tsim *sim)
{
	struct cylinder *z = self->state;

	for (int k = 0; k < 2; k++)
		TS_TRY(ts_region_length(self, sim, &z->given[k], z->c[k], &z->center[k]));
	TS_TRY(ts_region_length(self, sim, &z->given[2], z->c[0], &z->radius));
	if (z->radius >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &self->where,
		       "region cylinder: the radius is %g, expected a number >= 0", z->radius);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct cylinder *z = self->state;

	TS_TRY(ts_region_init(self, sim));
	z->c[0] = z->axis == 0 ? 1 : 0;
	z->c[1] = z->axis == 2 ? 1 : 2;
	TS_TRY(ts_region_coord(self, sim, z->given_lo, z->axis, &z->lo));
	TS_TRY(ts_region_coord(self, sim, z->given_hi, z->axis, &z->hi));
	if (z->lo > z->hi)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "region cylinder: lo = %g is above hi = %g", z->lo, z->hi);
	return update(self, sim);
}

static bool contains(const struct ts_instance *self, const double x[3])
{
	const struct cylinder *z = self->state;
	double a = x[z->c[0]] - z->center[0], b = x[z->c[1]] - z->center[1];

	return a * a + b * b <= z->radius * z->radius && x[z->axis] >= z->lo && x[z->axis] <= z->hi;
}

static double depth(const struct ts_instance *self, const double x[3])
{
	const struct cylinder *z = self->state;
	double a = x[z->c[0]] - z->center[0], b = x[z->c[1]] - z->center[1];
	double in = z->radius - sqrt(a * a + b * b);
	double along = fmin(x[z->axis] - z->lo, z->hi - x[z->axis]);

	return in < 0 && along < 0 ? -sqrt(in * in + along * along) : fmin(in, along);
}

static double radial(const struct ts_instance *self, const double x[3])
{
	const struct cylinder *z = self->state;
	double a = x[z->c[0]] - z->center[0], b = x[z->c[1]] - z->center[1];

	return sqrt(a * a + b * b) / z->radius;
}

static int contact_points(const struct ts_instance *self, const double x[3], bool inside,
			  struct ts_region_contact_point *out)
{
	const struct cylinder *z = self->state;
	struct ts_frustum shape = { z->lo, z->hi, { z->radius, z->radius } };

	return ts_region_frustum_contact_points(&z->region, &shape, z->axis, z->c, z->center, x, inside, out);
}

static bool turns_in_place(const struct ts_instance *self)
{
	const struct cylinder *z = self->state;

	return ts_region_frustum_turns_in_place(&z->region, z->axis, z->c, z->center);
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

static double volume(const struct ts_instance *self)
{
	const struct cylinder *z = self->state;

	return TS_PI * z->radius * z->radius * (z->hi - z->lo);
}

static const struct ts_arg args[] = {
	TS_ENUM("axis", struct cylinder, axis, ts_axis_names, .flags = TS_POSITIONAL,
		.help = "direction of the axis"),
	TS_NUMBER("c1", struct cylinder, given[0], .flags = TS_POSITIONAL, .unit = "length",
		  .help = "center in the first of the other dimensions"),
	TS_NUMBER("c2", struct cylinder, given[1], .flags = TS_POSITIONAL, .unit = "length",
		  .help = "center in the second of the other dimensions"),
	TS_NUMBER("radius", struct cylinder, given[2], .flags = TS_POSITIONAL, .unit = "length",
		  .range = TS_NOT_NEGATIVE, .help = "radius"),
	TS_COORD("lo", struct cylinder, given_lo, .flags = TS_POSITIONAL, .unit = "length",
		 .help = "lower end along the axis, INF or EDGE"),
	TS_COORD("hi", struct cylinder, given_hi, .flags = TS_POSITIONAL, .unit = "length",
		 .help = "upper end along the axis, INF or EDGE"),
	TS_REGION_ARGS(struct cylinder),
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_cylinder)
const struct ts_region_style ts_region_cylinder = {
	.style = {
		.name = "cylinder",
		.kind = TS_KIND_REGION,
		.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
		.summary = "Cylinder along a coordinate axis",
		.doc = "All points between lo and hi whose distance from the axis is at most the radius.\n"
		       "The center is given in the other two dimensions, in the order x y z: (y, z) for\n"
		       "axis x, (x, z) for axis y, (x, y) for axis z. Center and radius may be\n"
		       "variables. In lattice units the radius is in spacings of the first of these\n"
		       "dimensions. Faces 1 to 3 are the lower end, the upper end and the curved side.",
		.example = "region hole cylinder z 0 0 0.25 0 1 units box\n"
			   "region outside cylinder z 0 0 0.25 INF INF side out units box",
		.args = args,
		.state_size = sizeof(struct cylinder),
		.init = init,
	},
	.contains = contains,
	.depth = depth,
	.radial = radial,
	.bounds = bounds,
	.volume = volume,
	.update = update,
	.faces = 3,
	.contact_points = contact_points,
	.turns_in_place = turns_in_place,
};
