/* Region: a ball. */
#include "particles/region.h"

#include "math/vec3.h"

#include "base/banned.h"

struct ball {
	struct ts_region region;
	double given_center[3], given_radius;
	double center[3], radius;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ball *b = self->state;

	ts_region_init(self, sim);
	ts_scale(b->region.scale, b->given_center, b->center);
	b->radius = b->region.scale * b->given_radius;
	return TS_OK;
}

static bool contains(const struct ts_instance *self, const double x[3])
{
	const struct ball *b = self->state;

	return ts_distance2(x, b->center) <= b->radius * b->radius;
}

static void bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	const struct ball *b = self->state;

	for (int d = 0; d < 3; d++) {
		lo[d] = b->center[d] - b->radius;
		hi[d] = b->center[d] + b->radius;
	}
}

static const struct ts_arg args[] = {
	TS_VEC3("center", struct ball, given_center, .flags = TS_POSITIONAL, .unit = "length",
		.help = "center of the ball"),
	TS_REAL("radius", struct ball, given_radius, .flags = TS_POSITIONAL, .unit = "length",
		.range = TS_NOT_NEGATIVE, .help = "radius of the ball"),
	TS_REGION_ARGS(struct ball),
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_sphere)
const struct ts_region_style ts_region_sphere = {
	.style = {
		.name = "sphere",
		.kind = TS_KIND_REGION,
		.summary = "A ball",
		.doc = "All points x with |x - center| <= radius.",
		.example = "region drop sphere 0 0 0.5 0.1 units box",
		.args = args,
		.state_size = sizeof(struct ball),
		.init = init,
	},
	.contains = contains,
	.bounds = bounds,
};
