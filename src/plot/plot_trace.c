#include "plot/plot_trace.h"

#include <math.h>
#include <string.h>

#include "base/banned.h"

static const double COLUMN = 0.5; /* width of a column in units: a third of that of a line */
enum { FEW = 4000, MANY = 20000 /* so many points, vertices of a line are all drawn */ };

/* ---- squares of the frame where something is drawn */

struct raster {
	unsigned char *taken; /* NULL: not used */
	size_t width, height;
};

static enum ts_status raster_start(struct raster *r, const struct ts_plot_layout *l)
{
	r->width = (size_t)((l->right - l->left) / COLUMN) + 1;
	r->height = (size_t)((l->bottom - l->top) / COLUMN) + 1;
	r->taken = ts_alloc(r->width * r->height, 1);
	return r->taken ? TS_OK : TS_NOMEM;
}

/* Takes the square at a place; whether it was free. */
static bool take(struct raster *r, const struct ts_plot_layout *l, double x, double y)
{
	const size_t i = (size_t)fmax((x - l->left) / COLUMN, 0), j = (size_t)fmax((y - l->top) / COLUMN, 0);
	unsigned char *square =
		&r->taken[(j < r->height ? j : r->height - 1) * r->width + (i < r->width ? i : r->width - 1)];

	if (*square)
		return false;
	*square = 1;
	return true;
}

/* Takes all squares along a line; whether one was free. */
static bool take_line(struct raster *r, const struct ts_plot_layout *l, const struct ts_plot_vertex *a,
		      const struct ts_plot_vertex *b)
{
	const int steps = (int)(fmax(fabs(b->x - a->x), fabs(b->y - a->y)) / COLUMN) + 1;
	bool any = false;

	for (int k = 0; k <= steps; k++)
		any |= take(r, l, a->x + (b->x - a->x) * k / steps, a->y + (b->y - a->y) * k / steps);
	return any;
}

/* Successive points in one column that are not yet vertices. */
struct run {
	struct ts_plot_vertex first, lowest, highest, last;
	double column;
	size_t n;
};

/* The line as it is being made: `pen` is the last vertex before clipping. */
struct maker {
	struct ts_plot_trace *trace;
	const struct ts_plot_layout *layout;
	struct run run;
	struct raster raster; /* of a line with many vertices */
	struct ts_plot_vertex pen;
	bool down, failed; /* down: a line leads from `pen` to the next vertex */
};

static void place_of(const struct ts_plot_layout *l, const struct ts_plot_series *s, double x, double y,
		     double *px, double *py)
{
	*px = l->left + ts_plot_scale_at(&l->x, x) * (l->right - l->left);
	*py = l->bottom - ts_plot_scale_at(ts_plot_layout_scale(l, s), y) * (l->bottom - l->top);
}

static enum ts_status add(struct ts_plot_trace *t, struct ts_plot_vertex v)
{
	TS_TRY(TS_GROW(t->vertex, t->capacity, t->n + 1));
	t->vertex[t->n++] = v;
	return TS_OK;
}

/* ---- lines */

/* The part of a line from a to b that is in the frame: Liang and Barsky. */
static bool clip(const struct ts_plot_layout *l, const struct ts_plot_vertex *a,
		 const struct ts_plot_vertex *b, double *from, double *to)
{
	const double dx = b->x - a->x, dy = b->y - a->y;
	const double p[4] = { -dx, dx, -dy, dy };
	const double q[4] = { a->x - l->left, l->right - a->x, a->y - l->top, l->bottom - a->y };

	*from = 0;
	*to = 1;
	for (int k = 0; k < 4; k++) {
		if (p[k] < 0)
			*from = fmax(*from, q[k] / p[k]);
		else if (p[k] > 0)
			*to = fmin(*to, q[k] / p[k]);
		else if (q[k] < -1e-9)
			return false;
	}
	return *from < *to;
}

static struct ts_plot_vertex between(const struct ts_plot_vertex *a, const struct ts_plot_vertex *b, double t)
{
	return (struct ts_plot_vertex){ a->x + t * (b->x - a->x), a->y + t * (b->y - a->y), b->point, false };
}

/* Of a line with many vertices, as one that goes forth and back in x, parts that are drawn already are left out. */
static bool is_needed(struct maker *m, const struct ts_plot_vertex *a, const struct ts_plot_vertex *b)
{
	if (m->trace->n < MANY)
		return true;
	if (!m->raster.taken && raster_start(&m->raster, m->layout) != TS_OK) {
		m->failed = true;
		return false;
	}
	return take_line(&m->raster, m->layout, a, b);
}

static void add_line(struct maker *m, struct ts_plot_vertex begin, struct ts_plot_vertex end)
{
	const struct ts_plot_trace *t = m->trace;

	if (!is_needed(m, &begin, &end))
		return;
	begin.begins = true;
	if (!t->n || t->vertex[t->n - 1].x != begin.x || t->vertex[t->n - 1].y != begin.y)
		m->failed |= add(m->trace, begin) != TS_OK;
	m->failed |= add(m->trace, end) != TS_OK;
}

static void draw_to(struct maker *m, struct ts_plot_vertex v)
{
	double from, to;

	if (m->down && clip(m->layout, &m->pen, &v, &from, &to))
		add_line(m, between(&m->pen, &v, from), between(&m->pen, &v, to));
	m->pen = v;
	m->down = true;
}

static void flush_run(struct maker *m)
{
	struct run *r = &m->run;
	const struct ts_plot_vertex *inner[2] = { &r->lowest, &r->highest };

	if (!r->n)
		return;
	if (r->lowest.point > r->highest.point)
		inner[0] = &r->highest, inner[1] = &r->lowest;
	draw_to(m, r->first);
	for (int k = 0; k < 2; k++)
		if (inner[k]->point != m->pen.point && inner[k]->point != r->last.point)
			draw_to(m, *inner[k]);
	if (r->last.point != r->first.point)
		draw_to(m, r->last);
	r->n = 0;
}

static void add_to_line(struct maker *m, struct ts_plot_vertex v)
{
	struct run *r = &m->run;
	const double column = floor(v.x / COLUMN);

	if (r->n && column != r->column)
		flush_run(m);
	if (!r->n++) {
		r->column = column;
		r->first = r->lowest = r->highest = v;
	}
	if (v.y > r->lowest.y)
		r->lowest = v;
	if (v.y < r->highest.y)
		r->highest = v;
	r->last = v;
}

static void lift(struct maker *m)
{
	flush_run(m);
	m->down = false;
}

static bool is_shown(const struct ts_plot_layout *l, const struct ts_plot_series *s, size_t k,
		     struct ts_plot_vertex *out)
{
	const struct ts_plot_axis x = { .log = l->x.log }, y = { .log = ts_plot_layout_scale(l, s)->log };

	if (k >= s->n || !ts_plot_shows(&x, ts_plot_x(s, k)) || !ts_plot_shows(&y, s->y[k]))
		return false;
	*out = (struct ts_plot_vertex){ .point = k };
	place_of(l, s, ts_plot_x(s, k), s->y[k], &out->x, &out->y);
	return true;
}

/* The two ends of a step: half way to the points beside it, as far to the other side where there is only one. `point` of
 * vertices is twice that of points, so that both ends differ. */
static void add_step(struct maker *m, const struct ts_plot_series *s, size_t k, struct ts_plot_vertex v)
{
	struct ts_plot_vertex before, after;
	const bool has_before = k > 0 && is_shown(m->layout, s, k - 1, &before),
		   has_after = is_shown(m->layout, s, k + 1, &after);
	double left = has_before ? 0.5 * (before.x - v.x) : 0, right = has_after ? 0.5 * (after.x - v.x) : 0;

	if (!has_before)
		left = has_after ? -right : -0.5;
	if (!has_after)
		right = has_before ? -left : 0.5;
	add_to_line(m, (struct ts_plot_vertex){ v.x + left, v.y, 2 * k, false });
	add_to_line(m, (struct ts_plot_vertex){ v.x + right, v.y, 2 * k + 1, false });
}

enum ts_status ts_plot_trace_line(struct ts_plot_trace *t, const struct ts_plot_layout *l,
				  const struct ts_plot_series *s)
{
	struct maker m = { .trace = t, .layout = l };

	t->n = 0;
	for (size_t k = 0; k < s->n && !m.failed; k++) {
		struct ts_plot_vertex v;

		if (!is_shown(l, s, k, &v))
			lift(&m);
		else if (s->style == TS_PLOT_STEPS)
			add_step(&m, s, k, v);
		else
			add_to_line(&m, v);
	}
	lift(&m);
	ts_free(m.raster.taken);
	return m.failed ? TS_NOMEM : TS_OK;
}

/* ---- points */

static bool is_inside(const struct ts_plot_layout *l, const struct ts_plot_vertex *v)
{
	return v->x >= l->left - 1e-6 && v->x <= l->right + 1e-6 && v->y >= l->top - 1e-6 &&
	       v->y <= l->bottom + 1e-6;
}

static bool is_alone(const struct ts_plot_layout *l, const struct ts_plot_series *s, size_t k)
{
	struct ts_plot_vertex v;

	return !(k > 0 && is_shown(l, s, k - 1, &v)) && !is_shown(l, s, k + 1, &v);
}

/* All points, or those without a neighbour. */
static enum ts_status trace(struct ts_plot_trace *t, const struct ts_plot_layout *l,
			    const struct ts_plot_series *s, bool all)
{
	struct raster raster = { 0 };
	enum ts_status status = TS_OK;

	t->n = 0;
	if (s->n > FEW)
		TS_TRY(raster_start(&raster, l));
	for (size_t k = 0; k < s->n && status == TS_OK; k++) {
		struct ts_plot_vertex v;

		if (is_shown(l, s, k, &v) && (all || is_alone(l, s, k)) && is_inside(l, &v) &&
		    (!raster.taken || take(&raster, l, v.x, v.y)))
			status = add(t, v);
	}
	ts_free(raster.taken);
	return status;
}

enum ts_status ts_plot_trace_points(struct ts_plot_trace *t, const struct ts_plot_layout *l,
				    const struct ts_plot_series *s)
{
	t->n = 0;
	return s->style == TS_PLOT_STEPS ? TS_OK : trace(t, l, s, ts_plot_has_points(s));
}

enum ts_status ts_plot_trace_errors(struct ts_plot_trace *t, const struct ts_plot_layout *l,
				    const struct ts_plot_series *s)
{
	t->n = 0;
	return s->error || s->x_error ? trace(t, l, s, true) : TS_OK;
}

void ts_plot_trace_release(struct ts_plot_trace *t)
{
	ts_free(t->vertex);
	*t = (struct ts_plot_trace){ 0 };
}

/* The error at a point; 0: none. */
static double error_at(const double *error, size_t point)
{
	const double size = error ? fabs(error[point]) : 0;

	return isfinite(size) ? size : 0;
}

bool ts_plot_error_bar(const struct ts_plot_layout *l, const struct ts_plot_series *s, size_t point,
		       double *top, double *bottom)
{
	const double error = error_at(s->error, point), y = s->y[point];
	double x;

	if (!(error > 0))
		return false;
	place_of(l, s, 1, y + error, &x, top);
	place_of(l, s, 1, y - error, &x, bottom);
	*top = fmin(fmax(*top, l->top), l->bottom);
	/* below zero on a logarithmic axis: to the edge */
	*bottom = isnan(*bottom) ? l->bottom : fmin(fmax(*bottom, l->top), l->bottom);
	return true;
}

bool ts_plot_error_bar_x(const struct ts_plot_layout *l, const struct ts_plot_series *s, size_t point,
			 double *left, double *right)
{
	const double error = error_at(s->x_error, point), x = ts_plot_x(s, point);
	double y;

	if (!(error > 0))
		return false;
	place_of(l, s, x - error, 1, left, &y);
	place_of(l, s, x + error, 1, right, &y);
	*left = isnan(*left) ? l->left : fmin(fmax(*left, l->left), l->right);
	*right = fmin(fmax(*right, l->left), l->right);
	return true;
}
