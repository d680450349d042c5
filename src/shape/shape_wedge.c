/* Wedge-shaped hopper: two inclined walls above a slot, a bin of parallel walls above them. */
#include <math.h>

#include "math/constants.h"
#include "shape/internal.h"
#include "shape/lathe.h"

#include "base/banned.h"

const struct ts_arg ts_shape_wedge_args[] = {
	TS_SHAPE_LENGTH("width", wedge.width, "distance of the walls at the upper end, along x"),
	TS_SHAPE_LENGTH("outlet", wedge.outlet, "width of the slot, along x"),
	TS_SHAPE_LENGTH("depth", wedge.depth, "length of the slot along y, about the origin"),
	TS_REAL("half_angle", struct ts_shape_sizes, wedge.angle, .range = TS_WITHIN, .lo = 0, .hi = 90,
		.unit = "degrees", .help = "angle between the inclined walls and z; 90: a flat bottom"),
	TS_SHAPE_LENGTH_OR("height", wedge.height, "0", "height of the bin above the inclined walls"),
	TS_BOOL("ends", struct ts_shape_sizes, wedge.ends, .fallback = "yes",
		.help = "whether there are end walls normal to y; no: in a box that is periodic in y"),
	TS_ARGS_END,
};

/* One storey: from half width a at height lo to b at hi. */
static void add_storey(struct ts_facets *f, const struct ts_shape_sizes *s, double a, double b, double lo,
		       double hi, const int n[3])
{
	double y = s->wedge.depth / 2;
	const double right[4][3] = { { a, -y, lo }, { a, y, lo }, { b, y, hi }, { b, -y, hi } };
	const double left[4][3] = { { -a, y, lo }, { -a, -y, lo }, { -b, -y, hi }, { -b, y, hi } };
	const double back[4][3] = { { a, y, lo }, { -a, y, lo }, { -b, y, hi }, { b, y, hi } };
	const double front[4][3] = { { -a, -y, lo }, { a, -y, lo }, { b, -y, hi }, { -b, -y, hi } };

	ts_facets_patch(f, right, n[1], n[2]);
	ts_facets_patch(f, left, n[1], n[2]);
	if (!s->wedge.ends || !(hi > lo))
		return;
	ts_facets_patch(f, back, n[0], n[2]);
	ts_facets_patch(f, front, n[0], n[2]);
}

void ts_shape_wedge(struct ts_facets *f, const struct ts_shape_sizes *s)
{
	double a = s->wedge.outlet / 2, b = s->wedge.width / 2, slope = s->wedge.angle * TS_PI / 180;
	double top = s->wedge.angle < 90 ? (b - a) / tan(slope) : 0, slant = hypot(top, b - a), least;
	int n[3];

	if (!(a < b)) {
		ts_facets_fail(f, TS_RANGE, "%s: the outlet %g is not narrower than the width %g", f->name,
			       s->wedge.outlet, s->wedge.width);
		return;
	}
	if (!(s->wedge.angle > 0)) {
		ts_facets_fail(f, TS_RANGE, "%s: the angle of the walls is 0; take a box with open faces",
			       f->name);
		return;
	}
	least = fmin(fmin(2 * a, slant), s->wedge.depth);
	if (s->wedge.height > 0)
		least = fmin(least, s->wedge.height);
	n[0] = ts_facets_count(f, 2 * b, least, TS_LATHE_FLAT_ASPECT);
	n[1] = ts_facets_count(f, s->wedge.depth, least, TS_LATHE_FLAT_ASPECT);
	if (!s->wedge.ends && n[1] < TS_SHAPE_PERIODIC_ROWS)
		n[1] = TS_SHAPE_PERIODIC_ROWS;
	n[2] = ts_facets_count(f, slant, least, TS_LATHE_FLAT_ASPECT);
	add_storey(f, s, a, b, 0, top, n);
	n[2] = ts_facets_count(f, s->wedge.height, least, TS_LATHE_FLAT_ASPECT);
	if (s->wedge.height > 0)
		add_storey(f, s, b, b, top, top + s->wedge.height, n);
}
