/* Screw of Archimedes: a shaft with a helical flight of constant thickness (along the axis). The surface of the flight is
 * its rectangular cross-section, moved along the helix; between two turns the shaft is a helical strip. Below the first
 * turn, and above the last one, the rest of the shaft is divided into columns from its end to the flight. */
#include <math.h>

#include "math/constants.h"
#include "shape/internal.h"
#include "shape/lathe.h"

#include "base/banned.h"

static const char *const hands[] = { "right", "left", NULL };

const struct ts_arg ts_shape_screw_args[] = {
	TS_SHAPE_LENGTH("radius", screw.radius, "outer radius of the flight"),
	TS_SHAPE_LENGTH("shaft", screw.shaft, "radius of the shaft"),
	TS_SHAPE_LENGTH("pitch", screw.pitch, "length of a turn"),
	TS_REAL("turns", struct ts_shape_sizes, screw.turns, .range = TS_WITHIN, .lo = 1, .hi = 1e4,
		.help = "number of turns; times the number of segments a whole number"),
	TS_SHAPE_LENGTH("thickness", screw.thickness, "thickness of the flight along the axis"),
	TS_REAL("length", struct ts_shape_sizes, screw.length, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "length",
		.help = "length of the shaft, with the flight in its middle; default: turns x pitch + 3 x "
			"thickness"),
	TS_ENUM("hand", struct ts_shape_sizes, screw.hand, hands, .fallback = "right",
		.help = "sense of the helix: a right-handed screw that turns by the right-hand rule about "
			"its axis moves grains against the axis"),
	TS_BOOL("periodic", struct ts_shape_sizes, screw.periodic, .fallback = "no",
		.help = "yes: a whole number of turns that ends where its periodic image begins; the box has "
			"the length turns x pitch along the axis"),
	TS_ARGS_END,
};

struct screw {
	double outer, inner, pitch, half, length,
		start;	  /* half the thickness; z of the middle of the flight at its start */
	int64_t n, steps; /* segments of a turn, and of the whole flight */
	int across, edge,
		strip; /* cells: from the shaft to the edge of the flight, across its edge, between two turns */
	bool turned;   /* points are turned upside down, which exchanges the ends */
};

static enum ts_status set_screw(struct ts_facets *f, const struct ts_shape_sizes *s, struct screw *c)
{
	double steps = s->screw.turns * f->segments, whole = floor(steps + 0.5), step,
	       flight = s->screw.pitch * s->screw.turns;

	*c = (struct screw){ .outer = s->screw.radius,
			     .inner = s->screw.shaft,
			     .pitch = s->screw.pitch,
			     .half = s->screw.thickness / 2,
			     .n = f->segments,
			     .steps = (int64_t)whole };
	c->length = isnan(s->screw.length) ? flight + 6 * c->half : s->screw.length;
	c->start = s->screw.periodic ? 0 : (c->length - flight) / 2;
	if (!(c->inner < c->outer))
		return ts_facets_fail(f, TS_RANGE,
				      "%s: the shaft of radius %g is not thinner than the flight of radius "
				      "%g",
				      f->name, c->inner, c->outer);
	if (!(2 * c->half < c->pitch))
		return ts_facets_fail(f, TS_RANGE, "%s: a flight of thickness %g fills its pitch of %g",
				      f->name, 2 * c->half, c->pitch);
	if (fabs(steps - whole) > 1e-6)
		return ts_facets_fail(f, TS_RANGE,
				      "%s: %g turns of %d segments are not a whole number of segments; take "
				      "%.8g or %.8g turns, or other segments",
				      f->name, s->screw.turns, f->segments, floor(steps) / f->segments,
				      ceil(steps) / f->segments);
	if (s->screw.periodic && (c->steps % c->n || !isnan(s->screw.length)))
		return ts_facets_fail(f, TS_RANGE,
				      "%s: a periodic screw has a whole number of turns, here %g, and no "
				      "`length`",
				      f->name, s->screw.turns);
	if (!s->screw.periodic && !(c->start > c->half))
		return ts_facets_fail(f, TS_RANGE, "%s: a shaft of length %g is shorter than its flight, %g",
				      f->name, c->length, flight + 2 * c->half);
	step = 2 * TS_PI * c->inner / (double)c->n;
	c->across = ts_facets_count(f, c->outer - c->inner, step, TS_LATHE_ASPECT);
	c->edge = ts_facets_count(f, 2 * c->half, step, TS_LATHE_ASPECT);
	c->strip = ts_facets_count(f, c->pitch - 2 * c->half, step, TS_LATHE_ASPECT);
	return f->status;
}

static double middle(const struct screw *c, int64_t j)
{
	return c->start + c->pitch * (double)j / (double)c->n;
}

static void helix_point(const struct screw *c, double r, int64_t j, double z, double x[3])
{
	double cs[2];

	ts_facets_direction(c->turned ? c->steps - j : j, c->n, cs);
	x[0] = r * cs[0];
	x[1] = r * cs[1];
	x[2] = c->turned ? c->length - z : z;
}

/* Adds n + 1 points (or n without the first one) along the shaft at step j, from z = lo to hi, with t as there. */
static void add_line(struct ts_facets *f, const struct screw *c, struct ts_rim *rim, int64_t j, double lo,
		     double hi, int n, int first)
{
	double x[3];

	for (int i = first; i <= n; i++) {
		double z = ts_facets_between(lo, hi, i, n);

		helix_point(c, c->inner, j, z, x);
		ts_rim_add(f, rim, z, x[0], x[1], x[2]);
	}
}

/* The band that a line in the (r, z) plane sweeps along the helix, from step 0 to `steps`. The twisted cells of both
 * sides of the flight are cut along the same diagonals, from the shaft outwards; else the thickness would be wrong to
 * first order in the length of the cells. */
static void add_band(struct ts_facets *f, const struct screw *c, const double from[2], const double to[2],
		     int cells, int64_t steps)
{
	int inwards = to[0] < from[0];
	double x[4][3];

	for (int64_t j = 0; j < steps; j++)
		for (int i = 0; i < cells && f->status == TS_OK; i++) {
			for (int k = 0; k < 4; k++) {
				int at = i + (k > 1);
				int64_t step = j + (k == 1 || k == 2);

				helix_point(c, ts_facets_between(from[0], to[0], at, cells), step,
					    middle(c, step) + ts_facets_between(from[1], to[1], at, cells),
					    x[k]);
			}
			ts_facets_triangle(f, x[0], x[1], x[2 + inwards]);
			ts_facets_triangle(f, x[inwards], x[2], x[3]);
		}
}

/* Column j of the shaft below the first turn: from z = 0 to the flight. */
static void add_column_line(struct ts_facets *f, const struct screw *c, struct ts_rim *rim, int64_t j)
{
	double top = middle(c, j) - c->half, step = 2 * TS_PI * c->inner / (double)c->n,
	       base = c->start - c->half;

	if (j < c->n) {
		add_line(f, c, rim, j, 0, top, ts_facets_count(f, top, step, TS_LATHE_ASPECT), 0);
	} else { /* the line where the flight begins, again */
		add_line(f, c, rim, j, 0, base, ts_facets_count(f, base, step, TS_LATHE_ASPECT), 0);
		add_line(f, c, rim, j, base, c->start + c->half, c->edge, 1);
		add_line(f, c, rim, j, c->start + c->half, top, c->strip, 1);
	}
	for (size_t i = 0; i < rim->n; i++)
		rim->node[i].t /= top;
}

/* One end: the columns of the shaft, its end face, and that of the flight. */
static void add_end(struct ts_facets *f, const struct screw *c)
{
	struct ts_rim left = { 0 }, right = { 0 };
	double z = c->turned ? c->length : 0, x[4][3];
	const double disc[2][2] = { { c->turned ? c->inner : 0, z }, { c->turned ? 0 : c->inner, z } };

	for (int64_t j = 0; j < c->n && f->status == TS_OK; j++) {
		ts_rim_clear(&left);
		ts_rim_clear(&right);
		add_column_line(f, c, &left, j);
		add_column_line(f, c, &right, j + 1);
		ts_facets_zip(f, &right, &left);
	}
	ts_rim_release(&left);
	ts_rim_release(&right);
	ts_lathe(f, disc, 2);
	for (int k = 0; k < 4; k++)
		helix_point(c, k == 1 || k == 2 ? c->outer : c->inner, 0,
			    c->start + (k > 1 ? c->half : -c->half), x[k]);
	ts_facets_patch(f, (const double(*)[3])x, c->across, c->edge);
}

void ts_shape_screw(struct ts_facets *f, const struct ts_shape_sizes *s)
{
	struct screw c;

	if (set_screw(f, s, &c) != TS_OK)
		return;
	const double corner[5][2] = { { c.inner, -c.half },
				      { c.outer, -c.half },
				      { c.outer, c.half },
				      { c.inner, c.half },
				      { c.inner, c.pitch - c.half } };

	f->mirrored = s->screw.hand == 1;
	add_band(f, &c, corner[0], corner[1], c.across, c.steps);
	add_band(f, &c, corner[1], corner[2], c.edge, c.steps);
	add_band(f, &c, corner[2], corner[3], c.across, c.steps);
	add_band(f, &c, corner[3], corner[4], c.strip, s->screw.periodic ? c.steps : c.steps - c.n);
	if (s->screw.periodic)
		return;
	add_end(f, &c);
	c.turned = true;
	add_end(f, &c);
}
