/* Region wedge: a sector of a cylinder. */
#include "base/axes.h"
#include "math/constants.h"
#include "region/region.h"

#include <math.h>

#include "base/banned.h"

struct wedge {
	struct ts_region region;
	int axis, c[2]; /* dimension of the axis; the next two, in cyclic order */
	struct {
		double center[2], radius, bounds[2], angle0, angle;
	} given;
	struct ts_words center_words, bounds_words;
	double center[2], radius, lo, hi;
	double start[2], end[2]; /* unit vectors along the two flat faces */
};

/* (cos, sin) of an angle in degrees; exact for multiples of 90. */
static void unit_vector(double degrees, double out[2])
{
	double quarters = rint(degrees / 90), rest = (degrees - 90 * quarters) * TS_PI / 180;
	int k = (int)fmod(quarters, 4);
	double c = cos(rest), s = sin(rest);

	k = k < 0 ? k + 4 : k;
	out[0] = k == 0 ? c : k == 1 ? -s : k == 2 ? -c : s;
	out[1] = k == 0 ? s : k == 1 ? c : k == 2 ? -s : -c;
}

static double cross_product(const double a[2], const double b[2])
{
	return a[0] * b[1] - a[1] * b[0];
}

/* Whether a vector from the axis points into the sector. */
static bool in_sector(const struct wedge *w, const double d[2])
{
	bool after = cross_product(w->start, d) >= 0, before = cross_product(w->end, d) <= 0;

	return w->given.angle <= 180 ? after && before : after || before;
}

static const struct ts_arg center_rows[] = {
	TS_REAL("c1", struct wedge, given.center[0], .flags = TS_POSITIONAL, .unit = "length",
		.help = "center in the next dimension, cyclically"),
	TS_REAL("c2", struct wedge, given.center[1], .flags = TS_POSITIONAL, .unit = "length",
		.help = "center in the one after"),
	TS_ARGS_END,
};

static const struct ts_arg bounds_rows[] = {
	TS_COORD("lo", struct wedge, given.bounds[0], .flags = TS_POSITIONAL, .unit = "length",
		 .help = "lower end along the axis"),
	TS_COORD("hi", struct wedge, given.bounds[1], .flags = TS_POSITIONAL, .unit = "length",
		 .help = "upper end along the axis"),
	TS_ARGS_END,
};

static enum ts_status read_pairs(struct ts_instance *self, struct tsim *sim)
{
	struct wedge *w = self->state;

	TS_TRY(ts_args_parse(sim, "region wedge: center", center_rows, w->center_words, &self->where,
			     &self->arena, w));
	return ts_args_parse(sim, "region wedge: bounds", bounds_rows, w->bounds_words, &self->where,
			     &self->arena, w);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct wedge *w = self->state;

	if (!w->region.defined)
		TS_TRY(read_pairs(self, sim));
	TS_TRY(ts_region_init(self, sim));
	for (int k = 0; k < 2; k++) {
		w->c[k] = (w->axis + 1 + k) % 3;
		w->center[k] = w->region.scale[w->c[k]] * w->given.center[k];
	}
	w->radius = w->region.scale[w->c[0]] * w->given.radius;
	TS_TRY(ts_region_coord(self, sim, w->given.bounds[0], w->axis, &w->lo));
	TS_TRY(ts_region_coord(self, sim, w->given.bounds[1], w->axis, &w->hi));
	if (w->lo > w->hi)
		return ts_fail(&sim->error, TS_RANGE, &self->where, "region wedge: lo = %g is above hi = %g",
			       w->lo, w->hi);
	if (!(w->given.angle > 0))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "region wedge: angle is %g, expected a number > 0, to 360", w->given.angle);
	unit_vector(w->given.angle0, w->start);
	unit_vector(w->given.angle0 + w->given.angle, w->end);
	return TS_OK;
}

static bool contains(const struct ts_instance *self, const double x[3])
{
	const struct wedge *w = self->state;
	double d[2] = { x[w->c[0]] - w->center[0], x[w->c[1]] - w->center[1] };

	return x[w->axis] >= w->lo && x[w->axis] <= w->hi &&
	       d[0] * d[0] + d[1] * d[1] <= w->radius * w->radius && in_sector(w, d);
}

/* Distance in the plane of the sector from the flat face along the unit vector `along`. */
static double distance_from_face(const struct wedge *w, const double along[2], const double d[2])
{
	double at = fmax(0, fmin(w->radius, along[0] * d[0] + along[1] * d[1]));

	return hypot(d[0] - at * along[0], d[1] - at * along[1]);
}

/* The same from the edge of the sector, inside > 0. */
static double depth_in_sector(const struct wedge *w, const double d[2])
{
	double r = hypot(d[0], d[1]);
	double face = fmin(distance_from_face(w, w->start, d), distance_from_face(w, w->end, d));

	if (w->given.angle >= 360)
		return w->radius - r;
	if (!in_sector(w, d))
		return -face;
	return r > w->radius ? w->radius - r : fmin(face, w->radius - r);
}

static double depth(const struct ts_instance *self, const double x[3])
{
	const struct wedge *w = self->state;
	double d[2] = { x[w->c[0]] - w->center[0], x[w->c[1]] - w->center[1] };
	double sector = depth_in_sector(w, d), along = fmin(x[w->axis] - w->lo, w->hi - x[w->axis]);

	return sector < 0 && along < 0 ? -hypot(sector, along) : fmin(sector, along);
}

/* Bounds of the center, the ends of the two faces, and the extreme points of the arc between them. */
static void bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	static const double around[4][2] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
	const struct wedge *w = self->state;

	lo[w->axis] = w->lo;
	hi[w->axis] = w->hi;
	for (int k = 0; k < 2; k++) {
		double least = fmin(0, fmin(w->start[k], w->end[k]));
		double most = fmax(0, fmax(w->start[k], w->end[k]));

		for (int q = 0; q < 4; q++) {
			if (!in_sector(w, around[q]))
				continue;
			least = fmin(least, around[q][k]);
			most = fmax(most, around[q][k]);
		}
		lo[w->c[k]] = w->center[k] + w->radius * least;
		hi[w->c[k]] = w->center[k] + w->radius * most;
	}
}

static double volume(const struct ts_instance *self)
{
	const struct wedge *w = self->state;

	return TS_PI * w->given.angle / 360 * w->radius * w->radius * (w->hi - w->lo);
}

static const struct ts_arg args[] = {
	TS_ENUM("axis", struct wedge, axis, ts_axis_names, .help = "direction of the axis"),
	TS_SOME_KEYWORD("center", struct wedge, center_words, 0,
			.help = "c1 c2: a point on the axis, in the other dimensions in cyclic order: y z, z "
				"x or x y"),
	TS_REAL("radius", struct wedge, given.radius, .range = TS_POSITIVE, .unit = "length",
		.help = "radius of the cylinder"),
	TS_SOME_KEYWORD("bounds", struct wedge, bounds_words, 0,
			.help = "lo hi: lower and upper end along the axis, or INF or EDGE"),
	TS_REAL("angle0", struct wedge, given.angle0, .unit = "degrees",
		.help = "angle of the first flat face, from the first of the other dimensions towards the "
			"second"),
	TS_REAL("angle", struct wedge, given.angle, .unit = "degrees", .range = TS_WITHIN, .lo = 0, .hi = 360,
		.help = "angle between the two flat faces"),
	TS_REGION_ARGS(struct wedge),
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_wedge)
const struct ts_region_style ts_region_wedge = {
	.style = {
		.name = "wedge",
		.kind = TS_KIND_REGION,
		.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
		.summary = "Sector of a cylinder",
		.doc = "All points of a cylinder between two half-planes from its axis, at angle0 and at\n"
		       "angle0 + angle. Angles are in degrees and increase from y to z about axis x,\n"
		       "from z to x about y, from x to y about z.",
		.example = "region slice wedge axis z center 0 0 radius 0.25 bounds 0 1 angle0 -22.5 angle 45 "
			   "&\n"
			   "  units box",
		.args = args,
		.state_size = sizeof(struct wedge),
		.init = init,
	},
	.contains = contains,
	.depth = depth,
	.bounds = bounds,
	.volume = volume,
	.faces = 5,
};
