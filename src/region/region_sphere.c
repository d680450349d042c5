/* Region sphere. */
#include "math/constants.h"
#include "region/region.h"

#include <math.h>

#include "math/vec3.h"

#include "base/banned.h"

struct sphere {
	struct ts_region region;
	struct ts_number given[4]; /* center, radius */
	double center[3], radius;
};

static enum ts_status update(struct ts_instance *self, struct tsim *sim)
{
	struct sphere *b = self->state;

	for (int d = 0; d < 3; d++)
		TS_TRY(ts_region_length(self, sim, &b->given[d], d, &b->center[d]));
	TS_TRY(ts_region_length(self, sim, &b->given[3], 0, &b->radius));
	if (b->radius >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &self->where,
		       "region sphere: the radius is %g, expected a number >= 0", b->radius);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	TS_TRY(ts_region_init(self, sim));
	return update(self, sim);
}

static bool contains(const struct ts_instance *self, const double x[3])
{
	const struct sphere *b = self->state;

	return ts_distance2(x, b->center) <= b->radius * b->radius;
}

static double depth(const struct ts_instance *self, const double x[3])
{
	const struct sphere *b = self->state;

	return b->radius - sqrt(ts_distance2(x, b->center));
}

static double radial(const struct ts_instance *self, const double x[3])
{
	const struct sphere *b = self->state;

	return sqrt(ts_distance2(x, b->center)) / b->radius;
}

static int contact_points(const struct ts_instance *self, const double x[3], bool inside,
			  struct ts_region_contact_point *out)
{
	const struct sphere *b = self->state;
	double d[3], r, sign = inside ? -1 : 1;

	ts_sub(x, b->center, d);
	r = ts_norm(d);
	if (b->region.open || !(r > 0) || !(b->radius > 0))
		return 0;
	*out = (struct ts_region_contact_point){ .distance = fabs(r - b->radius),
						 .curvature = sign / b->radius };
	ts_scale(sign / r, d, out->n);
	return 1;
}

static void bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	const struct sphere *b = self->state;

	for (int d = 0; d < 3; d++) {
		lo[d] = b->center[d] - b->radius;
		hi[d] = b->center[d] + b->radius;
	}
}

static double volume(const struct ts_instance *self)
{
	double r = ((const struct sphere *)self->state)->radius;

	return 4 * TS_PI / 3 * r * r * r;
}

static const struct ts_arg args[] = {
	TS_NUMBER("x", struct sphere, given[0], .flags = TS_POSITIONAL, .unit = "length",
		  .help = "x of the center"),
	TS_NUMBER("y", struct sphere, given[1], .flags = TS_POSITIONAL, .unit = "length",
		  .help = "y of the center"),
	TS_NUMBER("z", struct sphere, given[2], .flags = TS_POSITIONAL, .unit = "length",
		  .help = "z of the center"),
	TS_NUMBER("radius", struct sphere, given[3], .flags = TS_POSITIONAL, .unit = "length",
		  .range = TS_NOT_NEGATIVE, .help = "radius"),
	TS_REGION_ARGS(struct sphere),
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_sphere)
const struct ts_region_style ts_region_sphere = {
	.style = {
		.name = "sphere",
		.kind = TS_KIND_REGION,
		.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
		.summary = "Sphere",
		.doc = "All points x with |x - center| <= radius. Center and radius may be variables.",
		.example = "region drop sphere 0 0 0.5 0.1 units box",
		.args = args,
		.state_size = sizeof(struct sphere),
		.init = init,
	},
	.contains = contains,
	.depth = depth,
	.radial = radial,
	.bounds = bounds,
	.volume = volume,
	.update = update,
	.faces = 1,
	.contact_points = contact_points,
};
