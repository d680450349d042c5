/* Region ellipsoid: semi-axes along x, y and z. */
#include "math/constants.h"
#include "region/region.h"

#include "base/banned.h"

struct ellipsoid {
	struct ts_region region;
	struct ts_number given[6]; /* center, semi-axes */
	double center[3], half[3];
};

static enum ts_status update(struct ts_instance *self, struct tsim *sim)
{
	struct ellipsoid *e = self->state;

	for (int d = 0; d < 3; d++) {
		TS_TRY(ts_region_length(self, sim, &e->given[d], d, &e->center[d]));
		TS_TRY(ts_region_length(self, sim, &e->given[3 + d], d, &e->half[d]));
		if (!(e->half[d] > 0))
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "region ellipsoid: the half axis %c is %g, expected a number > 0",
				       'a' + d, e->half[d]);
	}
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	TS_TRY(ts_region_init(self, sim));
	return update(self, sim);
}

static bool contains(const struct ts_instance *self, const double x[3])
{
	const struct ellipsoid *e = self->state;
	double sum = 0;

	for (int d = 0; d < 3; d++) {
		double s = (x[d] - e->center[d]) / e->half[d];

		sum += s * s;
	}
	return sum <= 1;
}

static void bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	const struct ellipsoid *e = self->state;

	for (int d = 0; d < 3; d++) {
		lo[d] = e->center[d] - e->half[d];
		hi[d] = e->center[d] + e->half[d];
	}
}

static double volume(const struct ts_instance *self)
{
	const struct ellipsoid *e = self->state;

	return 4 * TS_PI / 3 * e->half[0] * e->half[1] * e->half[2];
}

#define NUMBER(name, k, help_, ...)                                                                          \
	TS_NUMBER(name, struct ellipsoid, given[k], .flags = TS_POSITIONAL, .unit = "length", .help = help_, \
		  __VA_ARGS__)
static const struct ts_arg args[] = {
	NUMBER("x", 0, "x of the center", .range = TS_ANY),
	NUMBER("y", 1, "y of the center", .range = TS_ANY),
	NUMBER("z", 2, "z of the center", .range = TS_ANY),
	NUMBER("a", 3, "semi-axis along x", .range = TS_POSITIVE),
	NUMBER("b", 4, "semi-axis along y", .range = TS_POSITIVE),
	NUMBER("c", 5, "semi-axis along z", .range = TS_POSITIVE),
	TS_REGION_ARGS(struct ellipsoid),
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_ellipsoid)
const struct ts_region_style ts_region_ellipsoid = {
	.style = {
		.name = "ellipsoid",
		.kind = TS_KIND_REGION,
		.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
		.summary = "Ellipsoid",
		.doc = "All points with ((x - x0)/a)^2 + ((y - y0)/b)^2 + ((z - z0)/c)^2 <= 1. Center\n"
		       "and semi-axes may be variables; the keyword `rotate` rotates the ellipsoid.",
		.example = "region egg ellipsoid 0 0 0.5 0.1 0.1 0.15 units box",
		.args = args,
		.state_size = sizeof(struct ellipsoid),
		.init = init,
	},
	.contains = contains,
	.bounds = bounds,
	.volume = volume,
	.update = update,
	.faces = 1,
};
