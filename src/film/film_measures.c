#include "film/film_measures.h"

#include <math.h>

#include "film/internal.h"

#include "base/banned.h"

/* Adds a force along an axis of the grid at the point (x, y) of the grid to its Cartesian sum. */
static void add_force(const struct ts_film *f, int axis, double force, double x, double y, double sum[2],
		      double *torque)
{
	double c = 1, s = 0;

	if (f->polar) {
		c = cos(y);
		s = sin(y);
	}
	sum[0] += axis == 0 ? force * c : -force * s;
	sum[1] += axis == 0 ? force * s : force * c;
	if (!torque)
		return;
	if (f->polar)
		*torque += axis == 1 ? force * x : 0;
	else
		*torque += axis == 0 ? -force * y : force * x;
}

/* Two neighbouring points between which p and h vary: centres of cells, or a centre and an edge or the side of a solid cell. */
struct segment {
	double h[2], p[2], x, y; /* x, y: the middle of the face */
	double inner;		 /* pressure on the face */
	double length;
};

/* The flow through a face where the gap steps: pressures in the cells beside it, velocities of the surfaces, and the share of
 * the fluid in the gap. */
struct step_flow {
	double p[2], u[2], share;
};

/* Pressure on the face, from the flow in one half of the segment. */
static double pressure_from_half(const struct ts_film *f, int axis, int i, int j,
				 const struct step_flow *flow, double length, int cell,
				 enum ts_film_half half)
{
	size_t at = ts_film_face(f, axis, i, j);
	int k = axis == 0 ? cell % f->n[0] : cell / f->n[0], along = half == TS_FILM_BELOW ? 1 : -1;
	double d = (f->face[axis][k + 1] - f->face[axis][k]) / 2;
	struct ts_film_section section = ts_film_section(f, axis, f->gap[cell]);
	double full = section.couette[0] * flow->u[0] + section.couette[1] * flow->u[1];

	if (f->polar && axis == 1)
		d *= ts_film_centre(f, 0, i);
	return flow->p[half] -
	       along * 12 * f->viscosity * d / section.poiseuille *
		       (f->flow[axis][at] / length + f->ride[half][axis][at] - flow->share * full);
}

/* With least_gap the flow is not that of the gap, and the halves differ: their mean does not depend on the direction of the
 * axis. */
static double pressure_at_step(const struct ts_film *f, int axis, int i, int j, const struct ts_film_sides *s,
			       double length)
{
	size_t at = ts_film_face(f, axis, i, j);
	struct step_flow flow = { .p = { ts_film_reduce(f, f->p[s->low]), ts_film_reduce(f, f->p[s->high]) },
				  .share = 1 };

	ts_film_face_velocity(f, axis, s, i, j, flow.u);
	if (f->transport[axis][at] != 0)
		flow.share = (f->flow[axis][at] - f->conductance[axis][at] * (flow.p[0] - flow.p[1])) /
			     f->transport[axis][at];
	return ts_film_expand(f,
			      0.5 * (pressure_from_half(f, axis, i, j, &flow, length, s->low, TS_FILM_BELOW) +
				     pressure_from_half(f, axis, i, j, &flow, length, s->high,
							TS_FILM_ABOVE)));
}

static struct segment segment_of(const struct ts_film *f, int axis, int i, int j,
				 const struct ts_film_sides *s)
{
	const int end = ts_film_cell_before(f, s);
	struct segment g;

	ts_film_end_gaps(f, axis, i, j, s, g.h);
	for (int side = 0; side < 2; side++) {
		const int cell = side ? s->high : s->low;

		g.p[side] = end < 0 || cell == end ? f->p[cell] : ts_film_end_pressure(f, axis, i, j, s);
	}
	g.x = axis == 0 ? f->face[0][i] : ts_film_centre(f, 0, i);
	g.y = axis == 1 ? f->face[1][j] : ts_film_centre(f, 1, j);
	g.length = ts_film_face_length(f, axis, i, j);
	g.inner = (g.p[0] + g.p[1]) / 2;
	if (f->shape == TS_FILM_STEPPED && end < 0 && g.length > 0)
		g.inner = pressure_at_step(f, axis, i, j, s, g.length);
	return g;
}

/* The gap ends at the side of a solid cell. */
static void add_block(const struct ts_film *f, struct ts_film_measures *m, int axis,
		      const struct ts_film_sides *s, const struct segment *g)
{
	const bool after = s->high >= 0 && f->kind[s->high] == TS_FILM_SOLID;

	if (s->low < 0 || s->high < 0)
		return;
	add_force(f, axis, (after ? 1 : -1) * (g->p[after] - f->ambient) * g->h[after] * g->length, g->x,
		  g->y, m->pressure_force, NULL);
}

/* Of a segment: integrals of p dh, and for each surface of couette dp, together h dp. The sum of p dh and h dp is the
 * difference of p h. */
static void add_segment(const struct ts_film *f, struct ts_film_measures *m, int axis, int i, int j)
{
	struct ts_film_sides s = ts_film_sides_of(f, axis, i, j);
	struct ts_film_section a, b;
	struct segment g;

	if (!s.open && ts_film_cell_before(f, &s) < 0)
		return;
	g = segment_of(f, axis, i, j, &s);
	a = ts_film_section(f, axis, g.h[0]);
	b = ts_film_section(f, axis, g.h[1]);
	for (int side = 0; side < 2; side++) {
		double dp = f->shape == TS_FILM_STEPPED
				    ? a.grip[side] * (g.inner - g.p[0]) + b.grip[side] * (g.p[1] - g.inner)
				    : (a.grip[side] + b.grip[side]) / 2 * (g.p[1] - g.p[0]);

		add_force(f, axis, -dp * g.length, g.x, g.y, m->shear[side], &m->torque[side]);
	}
	add_force(f, axis, -(g.inner - f->ambient) * (g.h[1] - g.h[0]) * g.length, g.x, g.y,
		  m->pressure_force, NULL);
	if (!s.open)
		add_block(f, m, axis, &s, &g);
}

static void add_edges(const struct ts_film *f, struct ts_film_measures *m)
{
	for (int axis = 0; axis < 2; axis++)
		for (int k = 0; k < f->n[1 - axis]; k++) {
			int low[2] = { axis == 0 ? 0 : k, axis == 0 ? k : 0 };
			int high[2] = { axis == 0 ? f->n[0] : k, axis == 0 ? k : f->n[1] };

			m->outflow[axis][0] -= f->flow[axis][ts_film_face(f, axis, low[0], low[1])];
			m->outflow[axis][1] += f->flow[axis][ts_film_face(f, axis, high[0], high[1])];
		}
}

/* Asperities: Cartesian grids. Their friction on the upper surface acts along the velocity of the lower one relative to it. */
static void add_touch(const struct ts_film *f, struct ts_film_measures *m, size_t c, double area)
{
	struct ts_film_touch touch = ts_film_touch(f, f->gap[c]);
	double u[2], speed;

	for (int axis = 0; axis < 2; axis++)
		u[axis] = f->velocity[0][axis][c] - f->velocity[1][axis][c];
	speed = hypot(u[0], u[1]);
	m->touch_load += touch.pressure * area;
	m->touch_area += touch.area * area;
	for (int axis = 0; axis < 2 && speed > 0; axis++)
		m->touch_friction[axis] += f->asperity.friction * touch.pressure * area * u[axis] / speed;
}

static void add_cell(const struct ts_film *f, struct ts_film_measures *m, int i, int j)
{
	size_t c = ts_film_at(f, i, j);
	double area = ts_film_area(f, i, j), x = ts_film_centre(f, 0, i), y = ts_film_centre(f, 1, j);
	double push = (f->p[c] - f->ambient) * area, unused;

	if (f->kind[c] == TS_FILM_SOLID)
		return;
	m->load += push;
	m->pressed += fabs(push);
	m->centre[0] += push * (f->polar ? x * cos(y) : x);
	m->centre[1] += push * (f->polar ? x * sin(y) : y);
	m->least_gap = fmin(m->least_gap, f->gap[c]);
	m->volume += ts_film_volume(f, f->gap[c], &unused) * (1 - f->empty[c]) * area;
	for (int axis = 0; axis < 2; axis++) {
		struct ts_film_section section = ts_film_section(f, axis, f->gap[c]);
		double drag = ts_film_viscosity(f, f->p[c]) * (1 - f->empty[c]) *
			      (f->velocity[1][axis][c] - f->velocity[0][axis][c]) * area;

		add_force(f, axis, section.drag[0] * drag, x, y, m->shear[0], &m->torque[0]);
		add_force(f, axis, -section.drag[1] * drag, x, y, m->shear[1], &m->torque[1]);
	}
	if (f->asperity.density > 0)
		add_touch(f, m, c, area);
}

/* Height and place of the maximum of the parabola through three points; the middle one is the highest. */
static double parabola_top(const double x[3], const double p[3], double *at)
{
	double a = (p[0] - p[1]) / (x[0] - x[1]), b = (p[2] - p[1]) / (x[2] - x[1]);
	double bend = (b - a) / (x[2] - x[0]), slope = a - bend * (x[0] - x[1]), d;

	*at = x[1];
	if (!(bend < 0))
		return 0;
	d = -slope / (2 * bend);
	*at += d;
	return d * (slope + bend * d);
}

/* Rise above the highest centre along one axis; 0 at edges and beside cells that are not fluid. */
static double rise_along(const struct ts_film *f, int axis, const int top[2], double *at)
{
	double x[3], p[3];

	*at = ts_film_centre(f, axis, top[axis]);
	if (top[axis] == 0 || top[axis] == f->n[axis] - 1)
		return 0;
	for (int k = 0; k < 3; k++) {
		int i = top[0] + (axis == 0 ? k - 1 : 0), j = top[1] + (axis == 1 ? k - 1 : 0);

		if (f->kind[ts_film_at(f, i, j)] != TS_FILM_FLUID)
			return 0;
		x[k] = ts_film_centre(f, axis, axis == 0 ? i : j);
		p[k] = f->p[ts_film_at(f, i, j)];
	}
	return parabola_top(x, p, at);
}

/* Some cell has fluid. */
static void find_maximum(const struct ts_film *f, struct ts_film_measures *m)
{
	double x[2];
	int top[2] = { 0, 0 };

	m->p_max = -INFINITY;
	for (int j = 0; j < f->n[1]; j++)
		for (int i = 0; i < f->n[0]; i++)
			if (f->kind[ts_film_at(f, i, j)] != TS_FILM_SOLID &&
			    f->p[ts_film_at(f, i, j)] > m->p_max) {
				m->p_max = f->p[ts_film_at(f, i, j)];
				top[0] = i;
				top[1] = j;
			}
	for (int axis = 0; axis < 2; axis++)
		m->p_max += rise_along(f, axis, top, &x[axis]);
	m->p_max_at[0] = f->polar ? x[0] * cos(x[1]) : x[0];
	m->p_max_at[1] = f->polar ? x[0] * sin(x[1]) : x[1];
}

/* A load that is less than this part of what it is the sum of is none. */
static const double ROUND_OFF = 1e-12;

void ts_film_measure(const struct ts_film *f, struct ts_film_measures *m)
{
	*m = (struct ts_film_measures){ .least_gap = INFINITY };
	for (int j = 0; j < f->n[1]; j++)
		for (int i = 0; i < f->n[0]; i++)
			add_cell(f, m, i, j);
	/* the upper face of a periodic axis is the lower one */
	for (int axis = 0; axis < 2; axis++) {
		bool upper = f->edge[axis][0] != TS_FILM_PERIODIC;

		for (int j = 0; j < f->n[1] + (axis == 1 && upper); j++)
			for (int i = 0; i < f->n[0] + (axis == 0 && upper); i++)
				add_segment(f, m, axis, i, j);
	}
	for (int axis = 0; axis < 2; axis++)
		m->centre[axis] = fabs(m->load) > ROUND_OFF * m->pressed ? m->centre[axis] / m->load : NAN;
	add_edges(f, m);
	if (ts_film_has_fluid(f))
		find_maximum(f, m);
	else
		m->least_gap = m->p_max = m->p_max_at[0] = m->p_max_at[1] = NAN;
}
