/* Mixer: a shaft with flat blades around it. Shaft and blades are closed surfaces of their own; the root of each blade is
 * inside of the shaft, where no particle comes. */
#include <math.h>

#include "math/constants.h"
#include "math/vec3.h"
#include "shape/internal.h"
#include "shape/lathe.h"

#include "base/banned.h"

const struct ts_arg ts_shape_mixer_args[] = {
	TS_SHAPE_LENGTH("radius", mixer.radius, "distance of the ends of the blades from the axis"),
	TS_SHAPE_LENGTH("shaft", mixer.shaft, "radius of the shaft"),
	TS_SHAPE_LENGTH("length", mixer.length, "length of the shaft"),
	TS_INT("blades", struct ts_shape_sizes, mixer.blades, .range = TS_WITHIN, .lo = 1, .hi = 1000,
	       .help = "number of blades around the shaft, the first along x"),
	TS_SHAPE_LENGTH("width", mixer.width, "width of the blades"),
	TS_SHAPE_LENGTH("thickness", mixer.thickness, "thickness of the blades"),
	TS_REAL("tilt", struct ts_shape_sizes, mixer.tilt, .fallback = "90", .range = TS_WITHIN, .lo = 0,
		.hi = 180, .unit = "degrees",
		.help = "angle between the blades and the plane normal to the shaft: 90 for blades along it"),
	TS_REAL("at", struct ts_shape_sizes, mixer.at, .flags = TS_OPTIONAL, .unit = "length",
		.help = "z of the middle of the blades; default: half the length"),
	TS_ARGS_END,
};

/* A block along the direction of blade k: `corner` of the box about its middle line. */
static void blade_point(const struct ts_shape_sizes *s, int64_t k, double at, double r, double across,
			double up, double x[3])
{
	double cs[2], tilt = s->mixer.tilt * TS_PI / 180, side = across * cos(tilt) - up * sin(tilt);

	ts_facets_direction(k, s->mixer.blades, cs);
	x[0] = r * cs[0] - side * cs[1];
	x[1] = r * cs[1] + side * cs[0];
	x[2] = at + across * sin(tilt) + up * cos(tilt);
}

static void add_blade(struct ts_facets *f, const struct ts_shape_sizes *s, int64_t k, double root, double at,
		      const int n[3])
{
	const double bound[6] = { root,
				  s->mixer.radius,
				  -s->mixer.width / 2,
				  s->mixer.width / 2,
				  -s->mixer.thickness / 2,
				  s->mixer.thickness / 2 };
	double corner[4][3], y[3];

	for (int face = 0; face < 6; face++) {
		int d = face / 2, u = (d + 1) % 3, v = (d + 2) % 3;

		for (int i = 0; i < 4; i++) {
			y[d] = bound[face];
			y[u] = bound[2 * u + (i == 1 || i == 2)];
			y[v] = bound[2 * v + (i > 1)];
			blade_point(s, k, at, y[0], y[1], y[2], corner[i]);
		}
		f->reversed = face % 2 == 0;
		ts_facets_patch(f, (const double(*)[3])corner, n[u], n[v]);
	}
	f->reversed = false;
}

void ts_shape_mixer(struct ts_facets *f, const struct ts_shape_sizes *s)
{
	double at = isnan(s->mixer.at) ? s->mixer.length / 2 : s->mixer.at, shaft = s->mixer.shaft,
	       tilt = s->mixer.tilt * TS_PI / 180;
	double root = 0.5 * shaft,
	       least = fmin(s->mixer.thickness, fmin(s->mixer.width, s->mixer.radius - root));
	double reach = (s->mixer.width * sin(tilt) + s->mixer.thickness * fabs(cos(tilt))) / 2;
	const double profile[4][2] = {
		{ 0, 0 }, { shaft, 0 }, { shaft, s->mixer.length }, { 0, s->mixer.length }
	};
	int n[3];

	if (!(shaft < s->mixer.radius))
		ts_facets_fail(f, TS_RANGE, "%s: the blades end inside of the shaft: radius %g, shaft %g",
			       f->name, s->mixer.radius, shaft);
	if (!(at - reach >= 0 && at + reach <= s->mixer.length))
		ts_facets_fail(f, TS_RANGE, "%s: blades from z = %g to %g are not on the shaft, 0 to %g",
			       f->name, at - reach, at + reach, s->mixer.length);
	if (f->status != TS_OK)
		return;
	f->chord *= shaft / s->mixer.radius;
	n[0] = ts_facets_count(f, s->mixer.radius - root, least, TS_LATHE_FLAT_ASPECT);
	n[1] = ts_facets_count(f, s->mixer.width, least, TS_LATHE_FLAT_ASPECT);
	n[2] = ts_facets_count(f, s->mixer.thickness, least, TS_LATHE_FLAT_ASPECT);
	ts_lathe(f, profile, 4);
	for (int64_t k = 0; k < s->mixer.blades; k++)
		add_blade(f, s, k, root, at, n);
}
