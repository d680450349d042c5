/* Plots: ticks, ranges, values without a place, what is left of a million points, and SVG that is well-formed. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "deck.h"
#include "math/rng.h"
#include "plot/plot_raster.h"
#include "plot/plot_svg.h"
#include "plot/plot_terminal.h"
#include "plot/plot_trace.h"

static struct ts_plot_scale scale_of(const struct ts_plot *plot, int axis, int ticks)
{
	struct ts_plot_extent extent;
	struct ts_plot_scale scale;

	ts_plot_extent(plot, &extent);
	ts_plot_scale_set(&scale, plot, &extent, axis, ticks);
	return scale;
}

/* "TEXT TEXT ..." of the ticks of y values, with '|' for minor ones; then the title of the axis. */
static const char *ticks_of(const double *y, size_t n, bool log, char out[256])
{
	const struct ts_plot_series s = { .y = y, .n = n };
	const struct ts_plot p = { .y = { .label = "y", .log = log }, .series = &s, .n = 1 };
	const struct ts_plot_scale scale = scale_of(&p, 1, 6);
	struct ts_str text = { 0 };

	for (size_t k = 0; k < scale.n; k++)
		ts_str_addf(&text, "%s ", *scale.tick[k].text ? scale.tick[k].text : "|");
	ts_plot_scale_title(&scale, &p.y, &text);
	snprintf(out, 256, "%s", ts_str_text(&text));
	ts_str_release(&text);
	return out;
}

#define TICKS(log, expected, ...)                                                                     \
	do {                                                                                          \
		const double ticks_y[] = { __VA_ARGS__ };                                             \
		char ticks_text[256];                                                                 \
		ck_assert_str_eq(ticks_of(ticks_y, DECK_LENGTH(ticks_y), log, ticks_text), expected); \
	} while (0)

START_TEST(ticks_are_round)
{
	TICKS(false, "0 2 4 6 8 10 y", 0, 1, 9.7);
	TICKS(false, "-1.0 -0.5 0.0 0.5 1.0 y", -1.05, 1.02);
	TICKS(false, "3.40 3.42 3.44 3.46 3.48 3.50 y", 3.4, 3.5);
	TICKS(false, "0 5 10 15 20 y (10\u207b\u2076)", 2e-6, 2e-5);
	TICKS(false, "0.0 0.2 0.4 0.6 0.8 1.0 y (10\u2076)", 0, 1e6);
	TICKS(false, "0 20000 40000 60000 80000 y", 0, 8e4);
	TICKS(false, "0 20 40 60 80 100 y (10\u00b2\u2079\u2077)", 0, 1e299);
}
END_TEST

/* A range that is small against its distance from zero: the numbers are differences. */
START_TEST(far_from_zero)
{
	TICKS(false, "2 4 6 8 10 12 14 y \u2212 1234567 (10\u207b\u2076)", 1234567.000002, 1234567.000014);
	TICKS(false, "-54321.8 -54321.6 -54321.4 -54321.2 -54321.0 y", -54321.8, -54321.0);
	TICKS(false, "1.0 1.2 1.4 1.6 1.8 2.0 y + 7654322", -7654321, -7654320);
}
END_TEST

START_TEST(ticks_of_logarithms)
{
	TICKS(true, "0.001 0.01 0.1 1 10 100 1000 y", 1.1e-3, 990);
	TICKS(true, "1e-8 1e-6 1e-4 1e-2 1e0 1e2 1e4 1e6 1e8 y", 1e-8, 1e8);
	TICKS(true, "0.2 0.5 1 2 5 10 20 y", 0.2, 18);
	TICKS(true, "3.0 3.2 3.4 3.6 3.8 4.0 y", 3.0, 4.0);
	TICKS(true, "1e5 1e6 1e7 1e8 | | | | | | | y", 1e5, 3.1e8);
}
END_TEST

/* A constant, one point, none: there is a range, and the value is in its middle. */
START_TEST(ranges_without_width)
{
	const double values[] = { 0, 7.3, -1e-9, 1e300, -1e300, 1e-300 };
	struct ts_plot_scale scale;

	for (size_t k = 0; k < DECK_LENGTH(values); k++)
		for (size_t n = 0; n < 3; n++) {
			const double y[] = { values[k], values[k] };
			const struct ts_plot_series s = { .y = y, .n = n };
			const struct ts_plot p = { .series = &s, .n = 1 };

			scale = scale_of(&p, 1, 5);
			ck_assert(scale.lo < scale.hi && isfinite(scale.hi - scale.lo));
			ck_assert(scale.n >= 2);
			if (n)
				DECK_NEAR(ts_plot_scale_at(&scale, values[k]), 0.5, 1e-9);
		}
}
END_TEST

static void count(const double *y, size_t n, bool log, size_t hidden, double lo, double hi)
{
	const struct ts_plot_series s = { .y = y, .n = n };
	const struct ts_plot p = { .y = { .log = log }, .series = &s, .n = 1 };
	struct ts_plot_extent e;

	ts_plot_extent(&p, &e);
	ck_assert_uint_eq(e.points, n);
	ck_assert_uint_eq(e.hidden, hidden);
	ck_assert(e.lo[1] == lo && e.hi[1] == hi);
}

START_TEST(values_without_a_place)
{
	const double y[] = { NAN, 3, INFINITY, -2, 0, -INFINITY, 1e301, 0.5 };

	count(y, 8, false, 4, -2, 3);
	count(y, 8, true, 6, 0.5, 3);
	count(y, 1, true, 1, INFINITY, -INFINITY);
}
END_TEST

/* Ends that are given hold exactly; the other axis then shows what is between them. */
START_TEST(given_ends)
{
	const double x[] = { 1, 2, 3, 4 }, y[] = { 10, 20, 30, 1000 };
	const struct ts_plot_series s = { .x = x, .y = y, .n = 4 };
	const struct ts_plot p = { .x = { .lo = 1.5, .hi = 3.25 }, .series = &s, .n = 1 };
	const struct ts_plot half = { .x = { .lo = NAN, .hi = 2.5 }, .series = &s, .n = 1 };
	struct ts_plot_scale scale = scale_of(&p, 0, 5);

	ck_assert(scale.lo == 1.5 && scale.hi == 3.25);
	scale = scale_of(&p, 1, 5);
	ck_assert(scale.hi < 31 && scale.hi >= 30);
	scale = scale_of(&half, 0, 5);
	ck_assert(scale.lo <= 1 && scale.hi == 2.5);
}
END_TEST

/* However small the picture and wide the numbers, there is a frame. */
START_TEST(small_pictures)
{
	const double y[] = { -123456.78901, -123456.78902 };
	const struct ts_plot_series s = { .name = "a long name of a series that fills a line alone",
					  .y = y,
					  .n = 2 };
	const struct ts_plot p = { .title = "words and words and words and words and words",
				   .y = { "also a rather long name of an axis", "m" },
				   .series = &s,
				   .n = 1,
				   .width = 1,
				   .height = 1 };
	const struct ts_plot_font font = { 7, 17 };
	struct ts_plot_layout l;

	ck_assert(ts_plot_layout_set(&l, &p, &font) == TS_OK);
	ck_assert(l.right > l.left + 20 && l.bottom >= l.top + 0.49 * 160);
	ck_assert(l.width == 160 && l.height > 160);
	ts_plot_layout_release(&l);
}
END_TEST

/* Errors and marks are in the range; below zero on a logarithmic axis an error bar ends at the edge. */
START_TEST(errors_and_marks)
{
	const double y[] = { 1, 2 }, error[] = { 1.5, 0.25 };
	const struct ts_plot_series s = { .y = y, .error = error, .n = 2 };
	const struct ts_plot_mark mark = { .at = 40 };
	struct ts_plot p = { .series = &s, .n = 1, .mark = &mark, .marks = 1 };
	const struct ts_plot_font font = { 7, 17 };
	struct ts_plot_layout l;
	struct ts_plot_extent e;
	double top, bottom;

	ts_plot_extent(&p, &e);
	ck_assert(e.lo[1] == -0.5 && e.hi[1] == 40);
	p.y.log = true;
	ts_plot_extent(&p, &e);
	ck_assert(e.lo[1] == 1 && e.hi[1] == 40);
	ck_assert(ts_plot_layout_set(&l, &p, &font) == TS_OK);
	ck_assert(ts_plot_error_bar(&l, &s, 0, &top, &bottom));
	ck_assert(bottom == l.bottom && top > l.top && top < bottom);
	ts_plot_layout_release(&l);
}
END_TEST

/* Each y axis has the range of its own curves; they fill the same frame, and the right one takes room from it. */
START_TEST(two_axes)
{
	const double low[] = { 0, 1 }, high[] = { 100, 10000 };
	const struct ts_plot_series s[] = { { .y = low, .n = 2 }, { .y = high, .n = 2, .right = true } };
	struct ts_plot p = { .right = { .log = true, .label = "gap" }, .series = s, .n = 2 };
	const struct ts_plot_font font = { 7, 17 };
	struct ts_plot_trace t = { 0 };
	struct ts_plot_layout l, one;
	struct ts_plot_extent e;

	ts_plot_extent(&p, &e);
	ck_assert(e.lo[1] == 0 && e.hi[1] == 1 && e.lo[2] == 100 && e.hi[2] == 10000 && !e.hidden);
	ck_assert(ts_plot_layout_set(&l, &p, &font) == TS_OK);
	ck_assert(l.has_right && l.right_title.n == 1);
	ck_assert(ts_plot_trace_points(&t, &l, &s[0]) == TS_OK);
	DECK_NEAR(t.vertex[1].y, l.bottom - ts_plot_scale_at(&l.y, 1) * (l.bottom - l.top), 1e-9);
	ck_assert(ts_plot_trace_points(&t, &l, &s[1]) == TS_OK);
	DECK_NEAR(t.vertex[1].y, l.bottom - ts_plot_scale_at(&l.y2, 1e4) * (l.bottom - l.top), 1e-9);
	p.n = 1;
	ck_assert(ts_plot_layout_set(&one, &p, &font) == TS_OK);
	ck_assert(!one.has_right && one.right > l.right + 7);
	ts_plot_trace_release(&t);
	ts_plot_layout_release(&one);
	ts_plot_layout_release(&l);
}
END_TEST

/* Errors of x widen the range of x only; below zero on a logarithmic axis the bar ends at the edge. */
START_TEST(errors_of_x)
{
	const double x[] = { 1, 2 }, y[] = { 3, 4 }, error[] = { 1.5, NAN };
	const struct ts_plot_series s = { .x = x, .y = y, .x_error = error, .n = 2 };
	struct ts_plot p = { .series = &s, .n = 1 };
	const struct ts_plot_font font = { 7, 17 };
	struct ts_plot_layout l;
	struct ts_plot_extent e;
	double left, right;

	ck_assert(ts_plot_has_points(&s));
	ts_plot_extent(&p, &e);
	ck_assert(e.lo[0] == -0.5 && e.hi[0] == 2.5 && e.lo[1] == 3 && e.hi[1] == 4);
	p.x.log = true;
	ck_assert(ts_plot_layout_set(&l, &p, &font) == TS_OK);
	ck_assert(ts_plot_error_bar_x(&l, &s, 0, &left, &right));
	ck_assert(left == l.left);
	DECK_NEAR(right, l.left + ts_plot_scale_at(&l.x, 2.5) * (l.right - l.left), 1e-9);
	ck_assert(!ts_plot_error_bar_x(&l, &s, 1, &left, &right) &&
		  !ts_plot_error_bar(&l, &s, 0, &left, &right));
	ts_plot_layout_release(&l);
}
END_TEST

/* ---- a million points */

enum { MANY = 1000000 };

static double *noise(void)
{
	double *y = ts_alloc(MANY, sizeof *y);
	struct ts_rng rng = ts_rng_start(4711, 0);

	ck_assert_ptr_nonnull(y);
	for (size_t k = 0; k < MANY; k++)
		y[k] = ts_rng_uniform(&rng);
	return y;
}

/* Of each column of half a unit the extremes are kept, in particular a single spike; the number is bounded by the width. */
START_TEST(thinning_keeps_extremes)
{
	double *y = noise();
	const struct ts_plot_series s = { .y = y, .n = MANY, .style = TS_PLOT_LINES };
	const struct ts_plot p = { .series = &s, .n = 1 };
	const struct ts_plot_font font = { 7, 17 };
	struct ts_plot_layout l;
	struct ts_plot_trace t = { 0 };
	double *lowest, *highest, top = INFINITY;
	size_t columns;

	y[271828] = 5;
	ck_assert(ts_plot_layout_set(&l, &p, &font) == TS_OK);
	ck_assert(ts_plot_trace_line(&t, &l, &s) == TS_OK);
	columns = (size_t)(2 * l.width) + 2;
	ck_assert_uint_le(t.n, 4 * columns);
	lowest = ts_alloc(columns, sizeof *lowest);
	highest = ts_alloc(columns, sizeof *highest);
	for (size_t k = 0; k < columns; k++)
		lowest[k] = INFINITY, highest[k] = -INFINITY;
	for (size_t k = 0; k < t.n; k++) {
		const size_t column = (size_t)floor(2 * t.vertex[k].x);

		lowest[column] = fmin(lowest[column], t.vertex[k].y);
		highest[column] = fmax(highest[column], t.vertex[k].y);
		top = fmin(top, t.vertex[k].y);
	}
	for (size_t k = 0; k < MANY; k++) {
		const double x = l.left + ts_plot_scale_at(&l.x, (double)k) * (l.right - l.left),
			     at = l.bottom - ts_plot_scale_at(&l.y, y[k]) * (l.bottom - l.top);
		const size_t column = (size_t)floor(2 * x);

		ck_assert(at >= lowest[column] - 1e-9 && at <= highest[column] + 1e-9);
	}
	DECK_NEAR(top, l.bottom - ts_plot_scale_at(&l.y, 5) * (l.bottom - l.top), 1e-9);
	ts_free(lowest);
	ts_free(highest);
	ts_plot_trace_release(&t);
	ts_plot_layout_release(&l);
	ts_free(y);
}
END_TEST

/* A curve that goes around many times: its picture is whole, its size bounded. */
START_TEST(many_rounds)
{
	double *x = noise(), *y = noise();
	const struct ts_plot_series s = { .x = x, .y = y, .n = MANY, .style = TS_PLOT_LINES };
	const struct ts_plot p = { .series = &s, .n = 1 };
	const struct ts_plot_font font = { 7, 17 };
	struct ts_plot_layout l;
	struct ts_plot_trace t = { 0 };
	double lo = INFINITY, hi = -INFINITY;

	for (size_t k = 0; k < MANY; k++) {
		const double r = 1 + 0.1 * x[k];

		x[k] = r * cos(0.1 * (double)k);
		y[k] = r * sin(0.1 * (double)k);
	}
	ck_assert(ts_plot_layout_set(&l, &p, &font) == TS_OK);
	ck_assert(ts_plot_trace_line(&t, &l, &s) == TS_OK);
	ck_assert_uint_ge(t.n, 20000);
	ck_assert_uint_le(t.n, 80000);
	for (size_t k = 0; k < t.n; k++) {
		lo = fmin(lo, t.vertex[k].x);
		hi = fmax(hi, t.vertex[k].x);
	}
	DECK_NEAR(lo, l.left + ts_plot_scale_at(&l.x, -1.1) * (l.right - l.left), 0.5);
	DECK_NEAR(hi, l.left + ts_plot_scale_at(&l.x, 1.1) * (l.right - l.left), 0.5);
	ts_plot_trace_release(&t);
	ts_plot_layout_release(&l);
	ts_free(x);
	ts_free(y);
}
END_TEST

/* Gaps lift the pen, a point between two gaps is a dot, and lines end at the edge of the frame. */
START_TEST(gaps_and_edges)
{
	const double y[] = { 1, 2, NAN, 3, NAN, 4, 5, 60 };
	const struct ts_plot_series s = { .y = y, .n = 8, .style = TS_PLOT_LINES };
	const struct ts_plot p = {
		.x = { .lo = 0, .hi = 7 }, .y = { .lo = 0, .hi = 10 }, .series = &s, .n = 1
	};
	const struct ts_plot_font font = { 7, 17 };
	struct ts_plot_layout l;
	struct ts_plot_trace t = { 0 };

	ck_assert(ts_plot_layout_set(&l, &p, &font) == TS_OK);
	ck_assert(ts_plot_trace_line(&t, &l, &s) == TS_OK);
	ck_assert_uint_eq(t.n, 5);
	ck_assert(t.vertex[0].begins && !t.vertex[1].begins && t.vertex[2].begins && !t.vertex[4].begins);
	DECK_NEAR(t.vertex[4].y, l.top, 1e-9);
	ck_assert(t.vertex[4].x > t.vertex[3].x && t.vertex[4].x < l.right);
	ck_assert(ts_plot_trace_points(&t, &l, &s) == TS_OK);
	ck_assert_uint_eq(t.n, 1);
	ck_assert_uint_eq(t.vertex[0].point, 3);
	ts_plot_trace_release(&t);
	ts_plot_layout_release(&l);
}
END_TEST

/* A histogram: horizontal and vertical lines only, edges half way between. */
START_TEST(steps)
{
	const double x[] = { 1, 2, 4 }, y[] = { 1, 3, 2 };
	const struct ts_plot_series s = { .x = x, .y = y, .n = 3, .style = TS_PLOT_STEPS };
	const struct ts_plot p = { .x = { .lo = 0, .hi = 6 }, .series = &s, .n = 1 };
	const struct ts_plot_font font = { 7, 17 };
	const double edge[] = { 0.5, 1.5, 1.5, 3, 3, 5 };
	struct ts_plot_layout l;
	struct ts_plot_trace t = { 0 };

	ck_assert(ts_plot_layout_set(&l, &p, &font) == TS_OK);
	ck_assert(ts_plot_trace_line(&t, &l, &s) == TS_OK);
	ck_assert_uint_eq(t.n, 6);
	for (size_t k = 0; k < 6; k++)
		DECK_NEAR(t.vertex[k].x, l.left + edge[k] / 6 * (l.right - l.left), 1e-9);
	ts_plot_trace_release(&t);
	ts_plot_layout_release(&l);
}
END_TEST

/* ---- SVG */

static size_t occurrences(const char *text, const char *part)
{
	size_t n = 0;

	for (; (text = strstr(text, part)); text++)
		n++;
	return n;
}

/* Elements that are opened are closed in turn, and there is no `&` or `<` that is not one. */
static void assert_well_formed(const char *text)
{
	char open[16][16];
	size_t depth = 0;

	for (const char *c = text; *c; c++) {
		ck_assert((unsigned char)*c >= ' ' || *c == '\n');
		if (*c == '&')
			ck_assert(!strncmp(c, "&amp;", 5) || !strncmp(c, "&lt;", 4) ||
				  !strncmp(c, "&gt;", 4));
		if (*c != '<')
			continue;
		const char *end = strchr(c, '>');
		const size_t n = strcspn(c + 1, " >/");

		ck_assert(end && end > c + 1);
		if (c[1] == '/') {
			ck_assert(depth > 0);
			depth--;
			ck_assert(!strncmp(c + 2, open[depth], strlen(open[depth])));
		} else if (end[-1] != '/') {
			ck_assert(depth < 16 && n < 16);
			snprintf(open[depth], sizeof *open, "%.*s", (int)n, c + 1);
			depth++;
		}
		c = end;
	}
	ck_assert_uint_eq(depth, 0);
}

START_TEST(svg_is_well_formed)
{
	const double x[] = { 0.1, 0.2, 0.3 }, y[] = { 1, NAN, 3 }, error[] = { 0.1, 0.1, 0.2 };
	const struct ts_plot_series s[] = {
		{ .name = "a < b & \xff\xc3(", .x = x, .y = y, .error = error, .n = 3 },
		{ .x = x, .y = y, .n = 3, .style = TS_PLOT_STEPS },
		{ .name = "none", .x = x, .y = y, .style = TS_PLOT_LINES, .colour = 3 }
	};
	const struct ts_plot_mark mark[] = { { "<limit>", 2, false }, { NULL, 0.15, true } };
	const struct ts_plot p = { .title = "T\x01 \u00b5 <svg>",
				   .x = { "x", "m", .log = true },
				   .y = { "y & z", NULL },
				   .series = s,
				   .n = 3,
				   .mark = mark,
				   .marks = 2 };
	const struct ts_plot empty = { 0 };
	struct ts_str text = { 0 };

	ck_assert(ts_plot_svg_add(&p, &text) == TS_OK);
	assert_well_formed(text.text);
	ck_assert_uint_eq(occurrences(text.text, "a &lt; b &amp; \ufffd\ufffd("), 1);
	ck_assert_uint_eq(occurrences(text.text, "T\ufffd \u00b5 &lt;svg&gt;"), 2);
	ck_assert_uint_eq(occurrences(text.text, ">2 of 6 points not shown: not finite, or"), 1);
	ck_assert_uint_eq(occurrences(text.text, "viewBox=\"0 0 480 320\""), 1);
	ts_str_clear(&text);
	ck_assert(ts_plot_svg_add(&empty, &text) == TS_OK);
	assert_well_formed(text.text);
	ck_assert_uint_eq(occurrences(text.text, ">no data<"), 1);
	ts_str_release(&text);
}
END_TEST

/* The curve of the picture, read back: three points of known places. */
START_TEST(svg_has_the_points)
{
	const double x[] = { 0, 1, 2 }, y[] = { 0, 4, 1 };
	const struct ts_plot_series s = { .x = x, .y = y, .n = 3, .style = TS_PLOT_LINES };
	const struct ts_plot p = {
		.x = { .lo = 0, .hi = 2 }, .y = { .lo = 0, .hi = 4 }, .series = &s, .n = 1
	};
	const struct ts_plot_font font = { 7.5, 17 };
	struct ts_plot_layout l;
	struct ts_str text = { 0 };
	double v[6];
	const char *path;

	ck_assert(ts_plot_svg_add(&p, &text) == TS_OK);
	ck_assert(ts_plot_layout_set(&l, &p, &font) == TS_OK);
	path = strstr(text.text, "<path class=\"c1\" d=\"M");
	ck_assert_ptr_nonnull(path);
	ck_assert_int_eq(sscanf(path, "<path class=\"c1\" d=\"M%lf %lfl%lf %lfl%lf %lf", v, v + 1, v + 2,
				v + 3, v + 4, v + 5),
			 6);
	DECK_NEAR(v[0], l.left, 0.051);
	DECK_NEAR(v[1], l.bottom, 0.051);
	DECK_NEAR(v[0] + v[2], 0.5 * (l.left + l.right), 0.051);
	DECK_NEAR(v[1] + v[3], l.top, 0.051);
	DECK_NEAR(v[0] + v[2] + v[4], l.right, 0.051);
	DECK_NEAR(v[1] + v[3] + v[5], 0.75 * l.bottom + 0.25 * l.top, 0.051);
	ts_plot_layout_release(&l);
	ts_str_release(&text);
}
END_TEST

/* ---- pixels */

static int darkness(const struct ts_picture *p, double x, double y)
{
	const unsigned char *rgb = p->rgb + 3 * ((size_t)y * p->width + (size_t)x);

	return 765 - rgb[0] - rgb[1] - rgb[2];
}

/* The curve of a straight line passes through its pixels and leaves those beside it white; its colour is the first one. */
START_TEST(pixels_of_a_line)
{
	const double x[] = { 0, 3 }, y[] = { 0, 3 };
	const struct ts_plot_series s = { .x = x, .y = y, .n = 2, .style = TS_PLOT_LINES };
	const struct ts_plot p = {
		.x = { .lo = 0, .hi = 3 }, .y = { .lo = 0, .hi = 3 }, .series = &s, .n = 1
	};
	const struct ts_plot_font font = { 6, 15 };
	struct ts_plot_layout l;
	struct ts_picture picture = { 0 };

	ck_assert(ts_plot_layout_set(&l, &p, &font) == TS_OK);
	ck_assert(ts_plot_raster(&p, 2, &picture) == TS_OK);
	ck_assert_uint_eq(picture.width, 960);
	ck_assert_uint_eq(picture.height, 640);
	for (double part = 0.03; part < 1; part += 0.1) { /* between lines of the grid */
		const double px = 2 * (l.left + part * (l.right - l.left)),
			     py = 2 * (l.bottom - part * (l.bottom - l.top));
		const unsigned char *rgb = picture.rgb + 3 * ((size_t)py * 960 + (size_t)px);

		ck_assert_uint_eq((unsigned)rgb[0] << 16 | (unsigned)rgb[1] << 8 | rgb[2],
				  ts_plot_colour(0, false));
		ck_assert_int_eq(darkness(&picture, px + 8, py), 0);
		ck_assert_int_eq(darkness(&picture, px, py + 8), 0);
	}
	ts_picture_release(&picture);
	ck_assert(ts_plot_raster(&p, 1000, &picture) == TS_RANGE);
	ts_picture_release(&picture);
	ts_plot_layout_release(&l);
}
END_TEST

/* ---- terminal */

static void assert_terminal(const struct ts_plot *p, bool unicode, const char *expected)
{
	const struct ts_plot_terminal terminal = { .columns = 30, .rows = 9, .unicode = unicode };
	struct ts_str text = { 0 };

	ck_assert(ts_plot_terminal(p, &terminal, &text) == TS_OK);
	ck_assert_str_eq(text.text, expected);
	ts_str_release(&text);
}

START_TEST(terminal)
{
	const double x[] = { 0, 1, 2 }, y[] = { 0, 1, 0 }, low[] = { 1, NAN, 1 };
	const struct ts_plot_series s[] = {
		{ .name = "up", .x = x, .y = y, .n = 3, .style = TS_PLOT_LINES },
		{ .name = "low", .x = x, .y = low, .n = 3, .style = TS_PLOT_POINTS }
	};
	struct ts_plot p = {
		.title = "T\u00b2", .x = { "t", "\u00b5s", .lo = 0, .hi = 2 }, .series = s, .n = 1
	};

	p.y = (struct ts_plot_axis){ "y", "m", .lo = 0, .hi = 1 };
	assert_terminal(&p, true,
			"T\u00b2\n"
			"\u2812\u2812 up\n"
			"y (m)\n"
			"1.0\u2524          \u2880\u2824\u280a\u2811\u2824\u2840          \n"
			"   \u2502        \u2860\u2812\u2801    \u2808\u2812\u2884        \n"
			"0.5\u2524     \u28c0\u2814\u2809          \u2809\u2822\u28c0     \n"
			"   \u2502  \u2880\u2824\u280a                \u2811\u2824\u2840  \n"
			"0.0\u2524\u2860\u2812\u2801                    \u2808\u2812\u2884\n"
			"   "
			"\u2514\u252c\u2500\u2500\u2500\u2500\u2500\u2500\u2500\u2500\u2500\u2500\u2500\u2500"
			"\u252c\u2500\u2500\u2500\u2500\u2500\u2500\u2500\u2500\u2500\u2500\u2500\u252c\n"
			"    0            1           2\n"
			"                        t (\u00b5s)\n");
	p.n = 2;
	assert_terminal(&p, false,
			"T^2\n"
			"* up   + low\n"
			"y (m)\n"
			"1.0++          ****          +\n"
			"   |        ***    ***        \n"
			"0.5+     ***          ***     \n"
			"   |  ***                ***  \n"
			"0.0+**                      **\n"
			"   ++------------+-----------+\n"
			"    0            1           2\n"
			"                        t (us)\n"
			"1 of 6 points not shown: not finite\n");
}
END_TEST

/* Every allocation may fail. */
START_TEST(memory)
{
	const double y[] = { 1, NAN, 3, 2 }, error[] = { 1, 1, 1, 1 };
	const struct ts_plot_series s = { .name = "s", .y = y, .error = error, .n = 4 };
	const struct ts_plot p = { .title = "t", .y = { "y", "m" }, .series = &s, .n = 1 };
	const long before = ts_alloc_balance();

	for (int way = 0; way < 3; way++)
		for (long k = 1;; k++) {
			const struct ts_plot_terminal small = { .colour = true, .unicode = true };
			struct ts_str text = { 0 };
			struct ts_picture picture = { 0 };
			enum ts_status status;

			ts_alloc_fail_at(k);
			status = way == 0   ? ts_plot_svg_add(&p, &text)
				 : way == 1 ? ts_plot_raster(&p, 1, &picture)
					    : ts_plot_terminal(&p, &small, &text);
			ts_alloc_fail_at(0);
			ts_str_release(&text);
			ts_picture_release(&picture);
			ck_assert_int_eq(ts_alloc_balance(), before);
			if (status == TS_OK) {
				ck_assert_int_gt(k, 5);
				break;
			}
			ck_assert_int_eq(status, TS_NOMEM);
		}
}
END_TEST

/* ---- colours */

/* Red, green, blue of light. */
static void light_of(unsigned rgb, double out[3])
{
	for (int k = 0; k < 3; k++) {
		const double c = (rgb >> (16 - 8 * k) & 255) / 255.0;

		out[k] = c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
	}
}

/* WCAG 2.1. */
static double luminance(unsigned rgb)
{
	double c[3];

	light_of(rgb, c);
	return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

/* Graphics need a contrast of 3 to their ground. */
START_TEST(colours_are_seen)
{
	for (size_t k = 0; k < TS_PLOT_COLOURS; k++) {
		ck_assert_double_ge(1.05 / (luminance(ts_plot_colour(k, false)) + 0.05), 3);
		ck_assert_double_ge((luminance(ts_plot_colour(k, true)) + 0.05) /
					    (luminance(0x16181c) + 0.05),
				    3);
	}
}
END_TEST

static double cube_root(double t)
{
	return t > 0.008856 ? cbrt(t) : 7.787 * t + 16.0 / 116;
}

/* CIELAB for D65 of a colour as seen through a matrix on its light. */
static void seen(unsigned rgb, const double m[3][3], double lab[3])
{
	double c[3], s[3], f[3];

	light_of(rgb, c);
	for (int k = 0; k < 3; k++)
		s[k] = fmin(fmax(m[k][0] * c[0] + m[k][1] * c[1] + m[k][2] * c[2], 0), 1);
	f[0] = cube_root((0.4124 * s[0] + 0.3576 * s[1] + 0.1805 * s[2]) / 0.9505);
	f[1] = cube_root(0.2126 * s[0] + 0.7152 * s[1] + 0.0722 * s[2]);
	f[2] = cube_root((0.0193 * s[0] + 0.1192 * s[1] + 0.9505 * s[2]) / 1.089);
	lab[0] = 116 * f[1] - 16;
	lab[1] = 500 * (f[0] - f[1]);
	lab[2] = 200 * (f[1] - f[2]);
}

/* For people without one kind of cones, too: Machado et al. (2009), table 1, severity 1. */
START_TEST(colours_are_told_apart)
{
	static const double vision[4][3][3] = {
		{ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
		{ { 0.152286, 1.052583, -0.204868 },
		  { 0.114503, 0.786281, 0.099216 },
		  { -0.003882, -0.048116, 1.051998 } },
		{ { 0.367322, 0.860646, -0.227968 },
		  { 0.280085, 0.672501, 0.047413 },
		  { -0.011820, 0.042940, 0.968881 } },
		{ { 1.255528, -0.076749, -0.178779 },
		  { -0.078411, 0.930809, 0.147602 },
		  { 0.004733, 0.691367, 0.303900 } },
	};

	for (int v = 0; v < 4; v++)
		for (size_t i = 1; i < TS_PLOT_COLOURS; i++)
			for (size_t j = 0; j < i; j++)
				for (int dark = 0; dark < 2; dark++) {
					double a[3], b[3];

					seen(ts_plot_colour(i, dark), vision[v], a);
					seen(ts_plot_colour(j, dark), vision[v], b);
					ck_assert_double_ge(hypot(hypot(a[0] - b[0], a[1] - b[1]),
								  a[2] - b[2]),
							    22);
				}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("plot");
	TCase *tcase = tcase_create("plot");

	tcase_add_test(tcase, ticks_are_round);
	tcase_add_test(tcase, far_from_zero);
	tcase_add_test(tcase, ticks_of_logarithms);
	tcase_add_test(tcase, ranges_without_width);
	tcase_add_test(tcase, values_without_a_place);
	tcase_add_test(tcase, given_ends);
	tcase_add_test(tcase, small_pictures);
	tcase_add_test(tcase, errors_and_marks);
	tcase_add_test(tcase, two_axes);
	tcase_add_test(tcase, errors_of_x);
	tcase_add_test(tcase, thinning_keeps_extremes);
	tcase_add_test(tcase, many_rounds);
	tcase_add_test(tcase, gaps_and_edges);
	tcase_add_test(tcase, steps);
	tcase_add_test(tcase, svg_is_well_formed);
	tcase_add_test(tcase, svg_has_the_points);
	tcase_add_test(tcase, pixels_of_a_line);
	tcase_add_test(tcase, terminal);
	tcase_add_test(tcase, memory);
	tcase_add_test(tcase, colours_are_seen);
	tcase_add_test(tcase, colours_are_told_apart);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
