/* Coefficients of the flow through faces: the Reynolds equation in one dimension between two centres. */
#include <math.h>

#include "film/internal.h"

#include "base/banned.h"

static int wrapped(const struct ts_film *f, int axis, int i)
{
	return f->edge[axis][0] == TS_FILM_PERIODIC ? (i + f->n[axis]) % f->n[axis] : i;
}

static int cell_or_none(const struct ts_film *f, int i, int j)
{
	if (i < 0 || i >= f->n[0] || j < 0 || j >= f->n[1])
		return -1;
	return (int)ts_film_at(f, i, j);
}

struct ts_film_sides ts_film_sides_of(const struct ts_film *f, int axis, int i, int j)
{
	struct ts_film_sides s;
	bool edge;

	s.low = axis == 0 ? cell_or_none(f, wrapped(f, 0, i - 1), j)
			  : cell_or_none(f, i, wrapped(f, 1, j - 1));
	s.high = axis == 0 ? cell_or_none(f, wrapped(f, 0, i), j) : cell_or_none(f, i, wrapped(f, 1, j));
	edge = s.low < 0 || s.high < 0;
	s.open = (!edge || f->edge[axis][s.high < 0] == TS_FILM_PRESSURE) &&
		 (s.low < 0 || f->kind[s.low] != TS_FILM_SOLID) &&
		 (s.high < 0 || f->kind[s.high] != TS_FILM_SOLID);
	return s;
}

double ts_film_face_length(const struct ts_film *f, int axis, int i, int j)
{
	if (axis == 1)
		return f->face[0][i + 1] - f->face[0][i];
	return (f->face[1][j + 1] - f->face[1][j]) * (f->polar ? f->face[0][i] : 1);
}

/* Width of the cell on one side of the lower face of (i, j), along the axis. */
static double width_beside(const struct ts_film *f, int axis, int k, bool high)
{
	int cell = wrapped(f, axis, high ? k : k - 1);

	return f->face[axis][cell + 1] - f->face[axis][cell];
}

/* The values at an edge are those of the cell (i, j) and `reach` times the difference to those of the cell `other`: linear
 * from two cells, shortened where the gap would be less than half of that of the cell. */
static double reach_of_edge(const struct ts_film *f, int axis, int i, int j, bool high, size_t *other)
{
	double h = f->gap[ts_film_at(f, i, j)], x[3], reach;
	int k = axis == 0 ? i : j, next = high ? k - 1 : k + 1;

	*other = ts_film_at(f, i, j);
	if (f->shape == TS_FILM_STEPPED || next < 0 || next >= f->n[axis])
		return 0;
	*other = axis == 0 ? ts_film_at(f, next, j) : ts_film_at(f, i, next);
	if (f->kind[*other] == TS_FILM_SOLID)
		return 0;
	x[0] = ts_film_centre(f, axis, next);
	x[1] = ts_film_centre(f, axis, k);
	x[2] = f->face[axis][high ? k + 1 : k];
	reach = (x[2] - x[1]) / (x[1] - x[0]);
	return h + reach * (h - f->gap[*other]) < h / 2 ? h / 2 / (f->gap[*other] - h) : reach;
}

double ts_film_edge_gap(const struct ts_film *f, int axis, int i, int j, bool high)
{
	size_t other;
	double h = f->gap[ts_film_at(f, i, j)], reach = reach_of_edge(f, axis, i, j, high, &other);

	return h + reach * (h - f->gap[other]);
}

void ts_film_end_gaps(const struct ts_film *f, int axis, int i, int j, const struct ts_film_sides *s,
		      double h[2])
{
	h[0] = s->low >= 0 ? f->gap[s->low] : ts_film_edge_gap(f, axis, i, j, false);
	h[1] = s->high >= 0 ? f->gap[s->high]
			    : ts_film_edge_gap(f, axis, i - (axis == 0), j - (axis == 1), true);
	if (s->low >= 0 && f->kind[s->low] == TS_FILM_SOLID)
		h[0] = h[1];
	else if (s->high >= 0 && f->kind[s->high] == TS_FILM_SOLID)
		h[1] = h[0];
}

void ts_film_face_velocity(const struct ts_film *f, int axis, const struct ts_film_sides *s, int i, int j,
			   double u[2])
{
	int k = axis == 0 ? i : j;
	double a = 0, b = 1;

	if (s->low >= 0 && s->high >= 0) {
		a = width_beside(f, axis, k, false);
		b = width_beside(f, axis, k, true);
	}
	for (int side = 0; side < 2; side++) {
		double low = f->velocity[side][axis][s->low < 0 ? s->high : s->low];
		double high = f->velocity[side][axis][s->high < 0 ? s->low : s->high];

		u[side] = (b * low + a * high) / (a + b);
	}
}

/* Between two points beside a face: resistance int dx/h^3; half of the gap int dx/h^2 / int dx/h^3, which multiplies the
 * velocity of each surface; and `low`, with which a height that varies as the gap has the mean low z[0] + (1 - low) z[1]
 * of the same weight 1/h^3. */
struct face {
	double resistance, gap[2], low;
};

/* The gaps are h[2] at the distances d[2] from the face. */
static struct face integrate_segment(enum ts_film_shape shape, const double h[2], const double d[2])
{
	struct face face;

	if (shape == TS_FILM_STEPPED) {
		double a = d[0] / (h[0] * h[0] * h[0]), b = d[1] / (h[1] * h[1] * h[1]);

		face.resistance = a + b;
		face.gap[0] = (h[0] * a + h[1] * b) / (a + b) / 2;
		face.low = a / (a + b);
	} else {
		face.resistance = (d[0] + d[1]) * (h[0] + h[1]) / (2 * h[0] * h[0] * h[1] * h[1]);
		face.gap[0] = h[0] * h[1] / (h[0] + h[1]);
		face.low = h[1] / (h[0] + h[1]);
	}
	face.gap[1] = face.gap[0];
	return face;
}

/* Adds a part of the integrals int dx/poiseuille, int couette/poiseuille dx and int low/poiseuille dx. */
static void add_section(const struct ts_film *f, int axis, double h, double dx, double low, struct face *face)
{
	struct ts_film_section s = ts_film_section(f, axis, h);

	face->resistance += dx / s.poiseuille;
	face->low += dx * low / s.poiseuille;
	for (int side = 0; side < 2; side++)
		face->gap[side] += dx * s.couette[side] / s.poiseuille;
}

/* The same with slip or roughness. Where the gap is linear, dx = (d0 + d1)/(h0 h1) h^2 dt with t = (1/h - 1/h0)/(1/h1 - 1/h0), and the
 * integrands times h^2 are smooth functions of t, linear for plain surfaces: by the rule of Gauss. */
static struct face integrate_sections(const struct ts_film *f, int axis, const double h[2], const double d[2])
{
	static const double point[] = { 0.046910077030668004, 0.23076534494715845, 0.5, 0.76923465505284155,
					0.953089922969332 };
	static const double weight[] = { 0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
					 0.23931433524968324, 0.11846344252809454 };
	struct face face = { .resistance = 0 };

	if (f->shape == TS_FILM_STEPPED)
		for (int side = 0; side < 2; side++)
			add_section(f, axis, h[side], d[side], side == 0, &face);
	else
		for (int k = 0; k < 5; k++) {
			double at = 1 / ((1 - point[k]) / h[0] + point[k] / h[1]);

			add_section(f, axis, at, weight[k] * (d[0] + d[1]) * (at / h[0]) * (at / h[1]),
				    (1 - point[k]) * at / h[0], &face);
		}
	face.gap[0] /= face.resistance;
	face.gap[1] /= face.resistance;
	face.low /= face.resistance;
	return face;
}

static struct face integrate_face(const struct ts_film *f, int axis, int i, int j,
				  const struct ts_film_sides *s)
{
	double d[2] = { 0 }, h[2];
	int k = axis == 0 ? i : j;

	if (s->low >= 0 && f->kind[s->low] != TS_FILM_SOLID)
		d[0] = width_beside(f, axis, k, false) / 2;
	if (s->high >= 0 && f->kind[s->high] != TS_FILM_SOLID)
		d[1] = width_beside(f, axis, k, true) / 2;
	ts_film_end_gaps(f, axis, i, j, s, h);
	return ts_film_is_plain(f) ? integrate_segment(f->shape, h, d) : integrate_sections(f, axis, h, d);
}

int ts_film_cell_before(const struct ts_film *f, const struct ts_film_sides *s)
{
	const bool low = s->low >= 0 && f->kind[s->low] != TS_FILM_SOLID;
	const bool high = s->high >= 0 && f->kind[s->high] != TS_FILM_SOLID;

	return low == high ? -1 : low ? s->low : s->high;
}

/* Nothing flows through the face: in the half cell before it surfaces drag the fluid along, or a block that moves pushes it. In a
 * cavity the pressure is that of the cavity. */
static double pressure_of_no_flow(const struct ts_film *f, int axis, int i, int j, struct ts_film_sides s)
{
	const int cell = ts_film_cell_before(f, &s);
	const enum ts_film_half half = cell == s.low ? TS_FILM_BELOW : TS_FILM_ABOVE;
	const bool cavity = f->cavitation != TS_FILM_NONE;
	double u[2], q = f->ride[half][axis][ts_film_face(f, axis, i, j)], rise, p;
	struct face face;

	if (f->kind[cell] == TS_FILM_GIVEN || (cavity && !(f->p[cell] > f->cavity_pressure)))
		return f->p[cell];
	face = integrate_face(f, axis, i, j, &s);
	ts_film_face_velocity(f, axis, &s, i, j, u);
	rise = 12 * f->viscosity * face.resistance * (face.gap[0] * u[0] + face.gap[1] * u[1] - q);
	if (f->polar && axis == 1)
		rise *= ts_film_centre(f, 0, i);
	p = ts_film_expand(f, ts_film_reduce(f, f->p[cell]) + (half == TS_FILM_BELOW ? rise : -rise));
	if (isnan(p))
		return f->p[cell];
	return cavity ? fmax(p, f->cavity_pressure) : p;
}

double ts_film_end_pressure(const struct ts_film *f, int axis, int i, int j, const struct ts_film_sides *s)
{
	return s->open ? f->edge_pressure[axis][s->high < 0] : pressure_of_no_flow(f, axis, i, j, *s);
}

static void set_face(struct ts_film *f, int axis, int i, int j, const struct ts_film_sides *s)
{
	size_t at = ts_film_face(f, axis, i, j);
	double length = ts_film_face_length(f, axis, i, j), u[2];
	struct face face;

	f->conductance[axis][at] = f->transport[axis][at] = 0;
	if (!s->open)
		return;
	face = integrate_face(f, axis, i, j, s);
	if (f->polar && axis == 1)
		face.resistance *= ts_film_centre(f, 0, i);
	f->conductance[axis][at] = length / (12 * f->viscosity * face.resistance);
	ts_film_face_velocity(f, axis, s, i, j, u);
	f->transport[axis][at] = length * (face.gap[0] * u[0] + face.gap[1] * u[1]);
}

void ts_film_each_face(struct ts_film *f, ts_film_face_fn *visit)
{
	for (int axis = 0; axis < 2; axis++)
		for (int j = 0; j < f->n[1] + (axis == 1); j++)
			for (int i = 0; i < f->n[0] + (axis == 0); i++) {
				struct ts_film_sides s = ts_film_sides_of(f, axis, i, j);

				visit(f, axis, i, j, &s);
			}
}

void ts_film_set_faces(struct ts_film *f)
{
	bool in_time = f->cavitation == TS_FILM_JFO && f->time_step > 0;

	ts_film_each_face(f, set_face);
	for (int j = 0; j < f->n[1]; j++)
		for (int i = 0; i < f->n[0]; i++) {
			size_t c = ts_film_at(f, i, j);
			double rate = in_time ? (f->gap[c] - f->content[c]) / f->time_step : f->rate[c], part;

			if (ts_film_is_rough(f)) {
				ts_film_volume(f, f->gap[c], &part);
				rate *= part;
			}

			f->source[c] = f->kind[c] == TS_FILM_FLUID ? rate * ts_film_area(f, i, j) : 0;
		}
}

/* ---- shapes that move with their surfaces */

/* Rise from a cell to a face where the surfaces meet: `z`, that of the gap or the sum of the heights of both surfaces, is
 * that of the solid cell, but both surfaces are within the gap of the cell. */
static double rise_to_solid(const struct ts_film *f, const double *z, int cell, int solid)
{
	return fmin(fmax(z[solid] - z[cell], -f->gap[cell]), f->gap[cell]);
}

/* Height on a face less that of the cell beside it: of the low side, or of the high one. On an edge it is between that of
 * the cell and the one extrapolated, as the gap. */
static double rise_to_face(const struct ts_film *f, int axis, int i, int j, const double *z, bool from_high)
{
	struct ts_film_sides s = ts_film_sides_of(f, axis, i, j);
	bool edge = s.low < 0 || s.high < 0;
	int cell = from_high ? s.high : s.low, beyond = from_high ? s.low : s.high;
	double low, reach;
	size_t other;

	if (!edge && f->kind[beyond] == TS_FILM_SOLID)
		return rise_to_solid(f, z, cell, beyond);
	if (!edge && f->kind[cell] == TS_FILM_SOLID)
		return 0;
	low = integrate_face(f, axis, i, j, &s).low;
	if (edge) {
		cell = s.low < 0 ? s.high : s.low;
		reach = reach_of_edge(f, axis, cell % f->n[0], cell / f->n[0], s.low >= 0, &other);
		return (s.low < 0 ? low : 1 - low) * reach * (z[cell] - z[other]);
	}
	return from_high ? low * (z[s.low] - z[s.high]) : (1 - low) * (z[s.high] - z[s.low]);
}

/* Adds to the ride on the k-th face along the axis; the first and the last one of a periodic axis are the same. */
static void add_ride(struct ts_film *f, enum ts_film_half half, int axis, int i, int j, double flow)
{
	const int n = f->n[axis], k = axis == 0 ? i : j, other = n - k;

	f->ride[half][axis][ts_film_face(f, axis, i, j)] += flow;
	if (f->edge[axis][0] == TS_FILM_PERIODIC && k % n == 0)
		f->ride[half][axis][ts_film_face(f, axis, axis == 0 ? other : i, axis == 1 ? other : j)] +=
			flow;
}

static void carry_cell(struct ts_film *f, int axis, int i, int j, const double *z, double velocity,
		       double *rate)
{
	int k = axis == 0 ? i : j, up[2] = { i + (axis == 0), j + (axis == 1) };
	double width = f->face[axis][k + 1] - f->face[axis][k];
	double above = rise_to_face(f, axis, up[0], up[1], z, false);
	double below = rise_to_face(f, axis, i, j, z, true);

	rate[ts_film_at(f, i, j)] -= velocity * (above - below) / width;
	add_ride(f, TS_FILM_BELOW, axis, up[0], up[1], -velocity * above);
	add_ride(f, TS_FILM_ABOVE, axis, i, j, -velocity * below);
}

void ts_film_carry(struct ts_film *f, const double *z, const double velocity[2], const double *part,
		   double *rate)
{
	for (int axis = 0; axis < 2; axis++)
		for (int j = 0; j < f->n[1] && fabs(velocity[axis]) > 0; j++)
			for (int i = 0; i < f->n[0]; i++) {
				size_t c = ts_film_at(f, i, j);

				if (f->kind[c] != TS_FILM_SOLID)
					carry_cell(f, axis, i, j, z, velocity[axis] * (part ? part[c] : 1),
						   rate);
			}
}
