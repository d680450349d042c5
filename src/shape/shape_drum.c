/* Drum: a hollow cylinder with bars (lifters) along its wall. Its cross-section is a circle with rectangular
 * notches; between the bars the end walls are sectors from the circle to the tips of the bars, and a polygon inside
 * of the tips. */
#include <math.h>

#include "math/constants.h"
#include "shape/internal.h"
#include "shape/lathe.h"

#include "base/banned.h"

const struct ts_arg ts_shape_drum_args[] = {
	TS_SHAPE_LENGTH("radius", drum.radius, "radius"),
	TS_SHAPE_LENGTH("length", drum.length, "length"),
	TS_INT("lifters", struct ts_shape_sizes, drum.lifters, .fallback = "0", .range = TS_NOT_NEGATIVE,
	       .help = "number of bars, the first at x = radius"),
	TS_REAL("height", struct ts_shape_sizes, drum.height, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "length",
		.help = "of the bars: distance of their tips from the wall; default: a tenth of the radius"),
	TS_REAL("width", struct ts_shape_sizes, drum.width, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "length", .help = "of the bars; default: their height"),
	TS_SHAPE_OPEN(drum.open),
	TS_ARGS_END,
};

struct drum {
	double radius, tip, corner;	/* of the wall; of the middle and the corners of the tips */
	double at_wall, at_tip;		/* half the angle of a bar at the wall and at its tip, radian */
	double half;			/* half the width of a bar */
	int lifters, arc, rows, across; /* cells: between two bars, along a side of a bar, across its tip */
};

static enum ts_status set_drum(struct ts_facets *f, const struct ts_shape_sizes *s, struct drum *d)
{
	double R = s->drum.radius, h = isnan(s->drum.height) ? R / 10 : s->drum.height;
	double w = isnan(s->drum.width) ? h : s->drum.width, step = 2 * TS_PI * R / f->segments;

	*d = (struct drum){ .radius = R, .tip = R - h, .half = w / 2 };
	if (!(h < R))
		return ts_facets_fail(f, TS_RANGE,
				      "%s: lifters of height %g reach beyond the axis: the radius is %g",
				      f->name, h, R);
	if (s->drum.lifters > f->segments * 4)
		return ts_facets_fail(f, TS_RANGE, "%s: %lld lifters need more than %d segments", f->name,
				      (long long)s->drum.lifters, f->segments);
	d->lifters = (int)s->drum.lifters;
	d->corner = hypot(d->tip, d->half);
	d->at_tip = atan2(d->half, d->tip);
	d->at_wall = asin(fmin(1, d->half / R));
	if (d->corner >= R || d->at_tip >= TS_PI / d->lifters)
		return ts_facets_fail(f, TS_RANGE,
				      "%s: %d lifters of width %g and height %g touch each other or the wall "
				      "in a drum of radius %g",
				      f->name, d->lifters, w, h, R);
	d->arc = ts_facets_count(f, 2 * (TS_PI / d->lifters - d->at_wall) * R, step, 1);
	d->rows = ts_facets_count(f, h, step, 3);
	d->across = 2 * ts_facets_count(f, w / 2, step, 1); /* even: a point in the middle */
	return f->status;
}

/* Point i of the arc after bar k, in row j from the wall to the circle through the corners of the tips. */
static void sector_point(const struct drum *d, int k, int i, int j, double x[2])
{
	double middle = TS_PI * (2 * k + 1) / d->lifters, half = TS_PI / d->lifters,
	       part = (double)(2 * i - d->arc) / d->arc;
	double wall = middle + part * (half - d->at_wall), tip = middle + part * (half - d->at_tip);

	x[0] = ts_facets_between(d->radius * cos(wall), d->corner * cos(tip), j, d->rows);
	x[1] = ts_facets_between(d->radius * sin(wall), d->corner * sin(tip), j, d->rows);
}

/* Adds the arc after bar k in row j, from its point `from`; `row` is where the arc lies between wall and tip. */
static void add_arc(struct ts_facets *f, const struct drum *d, struct ts_rim *rim, int k, int j, double z)
{
	double x[2];

	for (int i = 0; i <= d->arc; i++) {
		sector_point(d, k, i, j, x);
		ts_rim_add(f, rim, (double)rim->n, x[0], x[1], z);
	}
}

/* Adds points `from` to `to` of the tip of bar k; point 0 is its first corner in the sense of rotation, point `across`
 * the other. */
static void add_tip(struct ts_facets *f, const struct drum *d, struct ts_rim *rim, int k, int from, int to,
		    double z)
{
	double a[2], b[2];

	sector_point(d, (k + d->lifters - 1) % d->lifters, d->arc, d->rows, a);
	sector_point(d, k, 0, d->rows, b);
	for (int i = from; i <= to; i++)
		ts_rim_add(f, rim, (double)rim->n, ts_facets_between(a[0], b[0], i, d->across),
			   ts_facets_between(a[1], b[1], i, d->across), z);
}

/* The whole cross-section at height z, anticlockwise: for each bar its tip, its side from the tip to the wall, the arc to
 * the next bar, and the side of that bar from the wall to its tip. */
static void add_section(struct ts_facets *f, const struct drum *d, struct ts_rim *rim, double z)
{
	double x[2];

	for (int k = 0; k < d->lifters; k++) {
		for (int j = d->rows; j > 0; j--) {
			sector_point(d, k, 0, j, x);
			ts_rim_add(f, rim, (double)rim->n, x[0], x[1], z);
		}
		add_arc(f, d, rim, k, 0, z);
		for (int j = 1; j <= d->rows; j++) {
			sector_point(d, k, d->arc, j, x);
			ts_rim_add(f, rim, (double)rim->n, x[0], x[1], z);
		}
		add_tip(f, d, rim, (k + 1) % d->lifters, 1, d->across - 1, z);
	}
	sector_point(d, 0, 0, d->rows, x);
	ts_rim_add(f, rim, (double)rim->n, x[0], x[1], z);
}

/* The polygon through the tips and the arcs between their corners, from the middle of the first tip. */
static void add_core_rim(struct ts_facets *f, const struct drum *d, struct ts_rim *rim, double z)
{
	add_tip(f, d, rim, 0, d->across / 2, d->across - 1, z);
	for (int k = 0; k < d->lifters; k++) {
		add_arc(f, d, rim, k, d->rows, z);
		add_tip(f, d, rim, (k + 1) % d->lifters, 1,
			k + 1 < d->lifters ? d->across - 1 : d->across / 2, z);
	}
	for (size_t i = 0; i < rim->n; i++) { /* the parameter of a circle */
		const double *x = rim->node[i].x;
		double t = atan2(x[1], x[0]) / (2 * TS_PI);

		rim->node[i].t = i == 0 ? 0 : i + 1 == rim->n ? 1 : t < 0 ? t + 1 : t;
	}
}

/* What lies inside of the tips: a strip to a smaller circle, and a disc. */
static void add_core(struct ts_facets *f, const struct drum *d, double z)
{
	struct ts_rim outer = { 0 }, inner = { 0 };
	int n = d->lifters * (d->arc + d->across), m = n > 16 ? (n + 1) / 2 : 8;
	double inside = d->tip - fmin(f->size, fmin(0.3, 8 * TS_PI / n) * d->tip);
	const double disc[2][2] = { { inside, z }, { 0, z } };

	add_core_rim(f, d, &outer, z);
	ts_rim_circle(f, &inner, inside, z, m);
	ts_facets_zip(f, &outer, &inner);
	f->segments = m;
	ts_lathe(f, disc, 2);
	ts_rim_release(&outer);
	ts_rim_release(&inner);
}

static void add_end(struct ts_facets *f, const struct drum *d, double z)
{
	struct ts_rim wall = { 0 }, tip = { 0 };
	int segments = f->segments;

	for (int k = 0; k < d->lifters; k++)
		for (int j = 0; j < d->rows; j++) {
			ts_rim_clear(&wall);
			ts_rim_clear(&tip);
			add_arc(f, d, &wall, k, j, z);
			add_arc(f, d, &tip, k, j + 1, z);
			ts_facets_zip(f, &wall, &tip);
		}
	ts_rim_release(&wall);
	ts_rim_release(&tip);
	add_core(f, d, z);
	f->segments = segments;
}

static void add_wall(struct ts_facets *f, const struct drum *d, double length, int open)
{
	struct ts_rim lower = { 0 }, upper = { 0 };
	double step = 2 * TS_PI * d->radius / f->segments,
	       narrow = fmin(2 * d->half / d->across, (d->radius - d->tip) / d->rows);
	int rows = ts_facets_count(f, length, fmin(step, 4 * narrow), TS_LATHE_ASPECT);

	if (open == TS_SHAPE_BOTH && rows < TS_SHAPE_PERIODIC_ROWS)
		rows = TS_SHAPE_PERIODIC_ROWS;
	for (int k = 0; k < rows && f->status == TS_OK; k++) {
		ts_rim_clear(&lower);
		ts_rim_clear(&upper);
		add_section(f, d, &lower, ts_facets_between(0, length, k, rows));
		add_section(f, d, &upper, ts_facets_between(0, length, k + 1, rows));
		ts_facets_zip(f, &lower, &upper);
	}
	ts_rim_release(&lower);
	ts_rim_release(&upper);
}

void ts_shape_drum(struct ts_facets *f, const struct ts_shape_sizes *s)
{
	const struct ts_shape_sizes plain = {
		.cylinder = { s->drum.radius, s->drum.length, 0, s->drum.open },
	};
	struct drum d;

	if (!s->drum.lifters) {
		if (!isnan(s->drum.height) || !isnan(s->drum.width))
			ts_facets_fail(f, TS_SYNTAX, "%s: height and width of the lifters, but no `lifters`",
				       f->name);
		ts_shape_cylinder(f, &plain);
		return;
	}
	if (set_drum(f, s, &d) != TS_OK)
		return;
	add_wall(f, &d, s->drum.length, s->drum.open);
	if (!(s->drum.open & TS_SHAPE_UPPER))
		add_end(f, &d, s->drum.length);
	f->reversed = true;
	if (!(s->drum.open & TS_SHAPE_LOWER))
		add_end(f, &d, 0);
	f->reversed = false;
}
