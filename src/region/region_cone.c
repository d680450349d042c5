/* Region cone: a truncated cone along a coordinate axis. */
#include "base/axes.h"
#include "math/constants.h"
#include "region/region_frustum.h"

#include <math.h>

#include "base/banned.h"

struct cone {
	struct ts_region region;
	int axis, c[2];		   /* dimension of the axis; the other two, ascending */
	struct ts_number given[4]; /* center (2), radius at the lower and at the upper end */
	double given_lo, given_hi;
	double center[2], radius[2], lo, hi;
};

static enum ts_status update(struct ts_instance *self, struct tsim *sim)
{
	struct cone *z = self->state;

	for (int k = 0; k < 2; k++) {
		TS_TRY(ts_region_length(self, sim, &z->given[k], z->c[k], &z->center[k]));
		TS_TRY(ts_region_length(self, sim, &z->given[2 + k], z->c[0], &z->radius[k]));
		if (!(z->radius[k] >= 0))
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "region cone: a radius is %g, expected a number >= 0", z->radius[k]);
	}
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct cone *z = self->state;

	TS_TRY(ts_region_init(self, sim));
	z->c[0] = z->axis == 0 ? 1 : 0;
	z->c[1] = z->axis == 2 ? 1 : 2;
	TS_TRY(ts_region_coord(self, sim, z->given_lo, z->axis, &z->lo));
	TS_TRY(ts_region_coord(self, sim, z->given_hi, z->axis, &z->hi));
	if (isinf(z->lo) || isinf(z->hi))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "region cone: both ends must be finite; EDGE is the face of the box");
	if (z->lo >= z->hi)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "region cone: lo = %g is not below hi = %g", z->lo, z->hi);
	return update(self, sim);
}

static bool contains(const struct ts_instance *self, const double x[3])
{
	const struct cone *z = self->state;
	double a = x[z->c[0]] - z->center[0], b = x[z->c[1]] - z->center[1];
	double along = (x[z->axis] - z->lo) / (z->hi - z->lo);
	double radius = z->radius[0] + along * (z->radius[1] - z->radius[0]);

	return along >= 0 && along <= 1 && a * a + b * b <= radius * radius;
}

/* Inside the smallest distance to the sides of the convex cross section in the half-plane through the axis. */
static double depth(const struct ts_instance *self, const double x[3])
{
	const struct cone *z = self->state;
	struct ts_frustum shape = { z->lo, z->hi, { z->radius[0], z->radius[1] } };
	struct ts_frustum_contact_point nearest;
	double a = x[z->c[0]] - z->center[0], b = x[z->c[1]] - z->center[1], r = sqrt(a * a + b * b);
	double length = z->hi - z->lo, widening = z->radius[1] - z->radius[0];
	double along = fmin(x[z->axis] - z->lo, z->hi - x[z->axis]);
	double in = z->radius[0] + (x[z->axis] - z->lo) / length * widening - r;
	double least = fmin(along, in * length / sqrt(length * length + widening * widening));

	if (least >= 0)
		return least;
	ts_frustum_nearest(&shape, 0, r, x[z->axis], &nearest);
	return -hypot(r - nearest.r, x[z->axis] - nearest.s);
}

static int contact_points(const struct ts_instance *self, const double x[3], bool inside,
			  struct ts_region_contact_point *out)
{
	const struct cone *z = self->state;
	struct ts_frustum shape = { z->lo, z->hi, { z->radius[0], z->radius[1] } };

	return ts_region_frustum_contact_points(&z->region, &shape, z->axis, z->c, z->center, x, inside, out);
}

static bool turns_in_place(const struct ts_instance *self)
{
	const struct cone *z = self->state;

	return ts_region_frustum_turns_in_place(&z->region, z->axis, z->c, z->center);
}

static void bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	const struct cone *z = self->state;
	double radius = fmax(z->radius[0], z->radius[1]);

	for (int k = 0; k < 2; k++) {
		lo[z->c[k]] = z->center[k] - radius;
		hi[z->c[k]] = z->center[k] + radius;
	}
	lo[z->axis] = z->lo;
	hi[z->axis] = z->hi;
}

/* pi h (R^2 + R r + r^2) / 3 */
static double volume(const struct ts_instance *self)
{
	const struct cone *z = self->state;
	double a = z->radius[0], b = z->radius[1];

	return TS_PI / 3 * (z->hi - z->lo) * (a * a + a * b + b * b);
}

static const struct ts_arg args[] = {
	TS_ENUM("axis", struct cone, axis, ts_axis_names, .flags = TS_POSITIONAL,
		.help = "direction of the axis"),
	TS_NUMBER("c1", struct cone, given[0], .flags = TS_POSITIONAL, .unit = "length",
		  .help = "center in the first of the other dimensions"),
	TS_NUMBER("c2", struct cone, given[1], .flags = TS_POSITIONAL, .unit = "length",
		  .help = "center in the second of the other dimensions"),
	TS_NUMBER("radius_lo", struct cone, given[2], .flags = TS_POSITIONAL, .unit = "length",
		  .range = TS_NOT_NEGATIVE, .help = "radius at the lower end"),
	TS_NUMBER("radius_hi", struct cone, given[3], .flags = TS_POSITIONAL, .unit = "length",
		  .range = TS_NOT_NEGATIVE, .help = "radius at the upper end"),
	TS_COORD("lo", struct cone, given_lo, .flags = TS_POSITIONAL, .unit = "length",
		 .help = "lower end along the axis, or EDGE"),
	TS_COORD("hi", struct cone, given_hi, .flags = TS_POSITIONAL, .unit = "length",
		 .help = "upper end along the axis, or EDGE"),
	TS_REGION_ARGS(struct cone),
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_cone)
const struct ts_region_style ts_region_cone = {
	.style = {
		.name = "cone",
		.kind = TS_KIND_REGION,
		.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
		.summary = "Truncated cone along a coordinate axis",
		.doc = "All points between lo and hi whose distance from the axis is at most a radius\n"
		       "that varies linearly from radius_lo to radius_hi. The center is given in the\n"
		       "other two dimensions, in the order x y z; center and radii may be variables. In\n"
		       "lattice units radii are in spacings of the first of these dimensions. Faces 1 to\n"
		       "3 are the lower end, the upper end and the curved side.",
		.example = "region funnel cone z 0 0 0.05 0.25 0 1 units box",
		.args = args,
		.state_size = sizeof(struct cone),
		.init = init,
	},
	.contains = contains,
	.depth = depth,
	.bounds = bounds,
	.volume = volume,
	.update = update,
	.faces = 3,
	.contact_points = contact_points,
	.turns_in_place = turns_in_place,
};
