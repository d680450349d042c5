#include "plot/plot_canvas.h"

#include <math.h>
#include <string.h>

#include "base/banned.h"

enum {
	EDGE = 8,
	TICK = 4,
	NUMBER = 6 /* distance of numbers */,
	CAP = 3 /* half the width of the end of an error bar */
};

/* ---- frame */

/* Position of a part of an axis. */
static double at_x(const struct ts_plot_layout *l, double part)
{
	return l->left + part * (l->right - l->left);
}

static double at_y(const struct ts_plot_layout *l, double part)
{
	return l->bottom - part * (l->bottom - l->top);
}

static void draw_line(struct ts_plot_canvas *c, double x0, double y0, double x1, double y1)
{
	c->move(c, x0, y0);
	c->line(c, x1, y1);
}

static void draw_grid(struct ts_plot_canvas *c, const struct ts_plot_layout *l, bool minor)
{
	c->begin(c, minor ? TS_PLOT_MINOR : TS_PLOT_GRID, TS_PLOT_INK);
	for (size_t k = 0; k < l->x.n; k++)
		if (!*l->x.tick[k].text == minor)
			draw_line(c, at_x(l, l->x.tick[k].at), l->top, at_x(l, l->x.tick[k].at), l->bottom);
	for (size_t k = 0; k < l->y.n; k++)
		if (!*l->y.tick[k].text == minor)
			draw_line(c, l->left, at_y(l, l->y.tick[k].at), l->right, at_y(l, l->y.tick[k].at));
	c->end(c);
}

/* Left and lower edge; at the right one an axis with its ticks, which have no grid. */
static void draw_frame(struct ts_plot_canvas *c, const struct ts_plot_layout *l)
{
	c->begin(c, TS_PLOT_FRAME, TS_PLOT_INK);
	draw_line(c, l->left, l->top, l->left, l->bottom);
	c->line(c, l->right, l->bottom);
	if (l->has_right)
		c->line(c, l->right, l->top);
	for (size_t k = 0; k < l->y2.n; k++)
		draw_line(c, l->right, at_y(l, l->y2.tick[k].at), l->right + TICK, at_y(l, l->y2.tick[k].at));
	c->end(c);
}

static enum ts_status draw_numbers(struct ts_plot_canvas *c, const struct ts_plot_layout *l,
				   const struct ts_plot_scale *scale)
{
	const bool y = scale != &l->x, right = scale == &l->y2;
	struct ts_str text = { 0 };
	bool failed;

	for (size_t k = 0; k < scale->n; k++) {
		const double at = scale->tick[k].at;

		ts_str_clear(&text);
		ts_plot_scale_pretty(scale->tick[k].text, &text);
		if (text.length && y)
			c->text(c, right ? l->right + NUMBER : l->left - NUMBER,
				at_y(l, at) + 0.27 * l->font.line, right ? TS_PLOT_START : TS_PLOT_END,
				TS_PLOT_NORMAL, text.text, text.length);
		else if (text.length)
			c->text(c, at_x(l, at), l->bottom + NUMBER + 0.75 * l->font.line, TS_PLOT_MIDDLE,
				TS_PLOT_NORMAL, text.text, text.length);
	}
	failed = text.failed;
	ts_str_release(&text);
	return failed ? TS_NOMEM : TS_OK;
}

static void draw_lines(struct ts_plot_canvas *c, const struct ts_plot_lines *lines, double x,
		       enum ts_plot_align align, enum ts_plot_letter letter)
{
	for (int k = 0; k < lines->n; k++)
		c->text(c, x, lines->line[k].y, align, letter, lines->line[k].text,
			(size_t)lines->line[k].length);
}

/* ---- curves */

static void draw_error_bars(struct ts_plot_canvas *c, const struct ts_plot_layout *l,
			    const struct ts_plot_series *s, const struct ts_plot_trace *t, size_t colour)
{
	c->begin(c, TS_PLOT_BAR, colour);
	for (size_t k = 0; k < t->n; k++) {
		const double x = t->vertex[k].x, y = t->vertex[k].y;
		double top, bottom, left, right;

		if (ts_plot_error_bar(l, s, t->vertex[k].point, &top, &bottom)) {
			draw_line(c, x - CAP, top, x + CAP, top);
			draw_line(c, x, top, x, bottom);
			draw_line(c, x - CAP, bottom, x + CAP, bottom);
		}
		if (ts_plot_error_bar_x(l, s, t->vertex[k].point, &left, &right)) {
			draw_line(c, left, y - CAP, left, y + CAP);
			draw_line(c, left, y, right, y);
			draw_line(c, right, y - CAP, right, y + CAP);
		}
	}
	c->end(c);
}

/* A line of the usual width would cover more than a fifth of the frame. */
static bool is_dense(const struct ts_plot_layout *l, const struct ts_plot_trace *t)
{
	double length = 0;

	for (size_t k = 1; k < t->n; k++)
		if (!t->vertex[k].begins)
			length += hypot(t->vertex[k].x - t->vertex[k - 1].x,
					t->vertex[k].y - t->vertex[k - 1].y);
	return 1.5 * length > (l->right - l->left) * (l->bottom - l->top) / 5;
}

static enum ts_status draw_series(struct ts_plot_canvas *c, const struct ts_plot_layout *l,
				  const struct ts_plot *plot, size_t k, struct ts_plot_trace *t)
{
	const struct ts_plot_series *s = &plot->series[k];
	const size_t colour = ts_plot_colour_of(plot, k), marker = ts_plot_marker_of(k);

	if (ts_plot_has_line(s)) {
		TS_TRY(ts_plot_trace_line(t, l, s));
		c->begin(c, is_dense(l, t) ? TS_PLOT_THIN : TS_PLOT_CURVE, colour);
		for (size_t v = 0; v < t->n; v++)
			(t->vertex[v].begins ? c->move : c->line)(c, t->vertex[v].x, t->vertex[v].y);
		c->end(c);
	}
	TS_TRY(ts_plot_trace_errors(t, l, s));
	draw_error_bars(c, l, s, t, colour);
	TS_TRY(ts_plot_trace_points(t, l, s));
	if (t->n)
		c->markers(c, t->vertex, t->n, t->n > TS_PLOT_CROWD ? TS_PLOT_FINE : marker, colour);
	return TS_OK;
}

static void draw_mark(struct ts_plot_canvas *c, const struct ts_plot_layout *l,
		      const struct ts_plot_mark *mark)
{
	const double at = ts_plot_scale_at(mark->vertical ? &l->x : &l->y, mark->at);
	const double x = at_x(l, mark->vertical ? at : 1), y = at_y(l, mark->vertical ? 1 : at);

	if (!(at >= 0 && at <= 1))
		return;
	c->begin(c, TS_PLOT_DASHED, TS_PLOT_INK);
	draw_line(c, mark->vertical ? x : l->left, y, x, mark->vertical ? l->bottom : y);
	c->end(c);
	if (!mark->name)
		return;
	if (mark->vertical) /* to the side that has more room */
		c->text(c, x + (at > 0.5 ? -4 : 4), l->bottom - 4, at > 0.5 ? TS_PLOT_END : TS_PLOT_START,
			TS_PLOT_SMALL, mark->name, strlen(mark->name));
	else
		c->text(c, x - 2, at > 0.9 ? y + 12 : y - 4, TS_PLOT_END, TS_PLOT_SMALL, mark->name,
			strlen(mark->name));
}

static void draw_legend(struct ts_plot_canvas *c, const struct ts_plot_layout *l, const struct ts_plot *plot)
{
	for (size_t k = 0; k < plot->n; k++) {
		const struct ts_plot_series *s = &plot->series[k];
		const size_t colour = ts_plot_colour_of(plot, k);
		const double x = l->entry[k].x, y = l->entry[k].y - 0.27 * l->font.line;

		if (!s->name || !*s->name)
			continue;
		if (ts_plot_has_line(s)) {
			c->begin(c, TS_PLOT_CURVE, colour);
			draw_line(c, x, y, x + TS_PLOT_SAMPLE - 6, y);
			c->end(c);
		}
		if (ts_plot_has_points(s))
			c->markers(c, (struct ts_plot_vertex[]){ { .x = x + 10, .y = y } }, 1,
				   ts_plot_marker_of(k), colour);
		c->text(c, x + TS_PLOT_SAMPLE, l->entry[k].y, TS_PLOT_START, TS_PLOT_NORMAL, s->name,
			strlen(s->name));
	}
}

enum ts_status ts_plot_canvas_draw(struct ts_plot_canvas *c, const struct ts_plot *plot,
				   const struct ts_plot_layout *l)
{
	struct ts_plot_trace trace = { 0 };
	enum ts_status status = TS_OK;

	draw_grid(c, l, true);
	draw_grid(c, l, false);
	draw_frame(c, l);
	for (size_t k = 0; k < plot->n && status == TS_OK; k++)
		status = draw_series(c, l, plot, k, &trace);
	ts_plot_trace_release(&trace);
	TS_TRY(status);
	for (size_t k = 0; k < plot->marks; k++)
		draw_mark(c, l, &plot->mark[k]);
	draw_legend(c, l, plot);
	TS_TRY(draw_numbers(c, l, &l->x));
	TS_TRY(draw_numbers(c, l, &l->y));
	TS_TRY(draw_numbers(c, l, &l->y2));
	draw_lines(c, &l->title, EDGE, TS_PLOT_START, TS_PLOT_BOLD);
	draw_lines(c, &l->y_title, EDGE, TS_PLOT_START, TS_PLOT_NORMAL);
	draw_lines(c, &l->right_title, l->width - EDGE, TS_PLOT_END, TS_PLOT_NORMAL);
	draw_lines(c, &l->x_title, l->right, TS_PLOT_END, TS_PLOT_NORMAL);
	draw_lines(c, &l->note, EDGE, TS_PLOT_START, TS_PLOT_SMALL);
	return TS_OK;
}
