#include "plot/plot_terminal.h"

#include <math.h>
#include <string.h>

#include "plot/plot_ascii.h"
#include "plot/plot_trace.h"

#include "base/banned.h"

enum { LEAST_COLUMNS = 24, LEAST_ROWS = 8, TICK_COLUMNS = 11, TICK_ROWS = 3 };
static const char symbols[] = "*+ox#@%&";
enum { SYMBOLS = sizeof symbols - 1, MARK = 255 };

struct screen {
	const struct ts_plot *plot;
	struct ts_plot_layout layout; /* a unit is a dot; the frame begins at 0, 0 */
	bool unicode, colour, braille;
	int columns, rows, left, right; /* letters of the frame, and to both sides of it */
	int across, down;		/* dots of a letter */
	unsigned char *dots;   /* [rows * columns]: the eight bits of a braille letter; without: 0 or 1 */
	unsigned char *series; /* the last one that has drawn there, or MARK */
	struct ts_str *out;
};

/* ---- curves */

static void set_dot(struct screen *s, double x, double y, size_t series)
{
	static const unsigned char bit[4][2] = { { 1, 8 }, { 2, 16 }, { 4, 32 }, { 64, 128 } };
	const int most_x = s->columns * s->across - 1, most_y = s->rows * s->down - 1;
	const int i = x < 0 ? 0 : x > most_x ? most_x : (int)x, j = y < 0 ? 0 : y > most_y ? most_y : (int)y;
	const size_t at = (size_t)(j / s->down * s->columns + i / s->across);

	s->dots[at] |= s->braille ? bit[j % 4][i % 2] : 1;
	s->series[at] = (unsigned char)(series == MARK ? MARK : series % MARK);
}

static void draw_line(struct screen *s, double x0, double y0, double x1, double y1, size_t series)
{
	const int steps = (int)ceil(fmax(fabs(x1 - x0), fabs(y1 - y0))) + 1;

	for (int k = 0; k <= steps; k++)
		set_dot(s, x0 + (x1 - x0) * k / steps, y0 + (y1 - y0) * k / steps, series);
}

/* Every third dot of a line across the frame; its name is in the legend. */
static void draw_mark(struct screen *s, const struct ts_plot_mark *mark)
{
	const struct ts_plot_layout *l = &s->layout;
	const double at = ts_plot_scale_at(mark->vertical ? &l->x : &l->y, mark->at);

	if (!(at >= 0 && at <= 1))
		return;
	for (double k = 0; k < (mark->vertical ? l->bottom : l->right); k += 3)
		set_dot(s, mark->vertical ? at * l->right : k, mark->vertical ? k : (1 - at) * l->bottom,
			MARK);
}

static enum ts_status draw_series(struct screen *s, size_t k, struct ts_plot_trace *t)
{
	const struct ts_plot_series *series = &s->plot->series[k];

	if (ts_plot_has_line(series)) {
		TS_TRY(ts_plot_trace_line(t, &s->layout, series));
		for (size_t v = 1; v < t->n; v++)
			if (!t->vertex[v].begins)
				draw_line(s, t->vertex[v - 1].x, t->vertex[v - 1].y, t->vertex[v].x,
					  t->vertex[v].y, k);
	}
	TS_TRY(ts_plot_trace_errors(t, &s->layout, series));
	for (size_t v = 0; v < t->n; v++) {
		double top, bottom, left, right;

		if (ts_plot_error_bar(&s->layout, series, t->vertex[v].point, &top, &bottom))
			draw_line(s, t->vertex[v].x, top, t->vertex[v].x, bottom, k);
		if (ts_plot_error_bar_x(&s->layout, series, t->vertex[v].point, &left, &right))
			draw_line(s, left, t->vertex[v].y, right, t->vertex[v].y, k);
	}
	TS_TRY(ts_plot_trace_points(t, &s->layout, series));
	for (size_t v = 0; v < t->n; v++)
		set_dot(s, t->vertex[v].x, t->vertex[v].y, k);
	return TS_OK;
}

/* ---- texts */

static void add_plain(struct screen *s, const char *text)
{
	if (s->unicode)
		ts_str_add(s->out, text);
	else
		ts_plot_ascii_add(text, strlen(text), s->out);
}

static void add_blanks(struct screen *s, int n)
{
	for (int k = 0; k < n; k++)
		ts_str_add(s->out, " ");
}

static void begin_colour(struct screen *s, size_t series)
{
	/* those of plot.h among the 256 of terminals, readable on black and on white */
	static const int code[TS_PLOT_COLOURS] = { 32, 166, 35, 169, 178, 74, 245 };

	if (s->colour && series != MARK)
		ts_str_addf(s->out, "\033[38;5;%dm", code[ts_plot_colour_of(s->plot, series)]);
}

static void end_colour(struct screen *s)
{
	ts_str_add(s->out, s->colour ? "\033[0m" : "");
}

/* Letters of a tick. */
static int tick_length(const struct screen *s, const struct ts_plot_tick *tick, struct ts_str *text)
{
	ts_str_clear(text);
	if (s->unicode)
		ts_plot_scale_pretty(tick->text, text);
	else
		ts_str_add(text, tick->text);
	return (int)ts_plot_letters(ts_str_text(text), text->length);
}

static int row_of(const struct screen *s, const struct ts_plot_tick *tick)
{
	return (int)fmin((1 - tick->at) * s->rows, s->rows - 1);
}

static int column_of(const struct screen *s, const struct ts_plot_tick *tick)
{
	return (int)fmin(tick->at * s->columns, s->columns - 1);
}

/* The tick with a number at a row or column of the frame; NULL: none. */
static const struct ts_plot_tick *tick_at(const struct screen *s, const struct ts_plot_scale *scale,
					  int place)
{
	const bool y = scale != &s->layout.x;

	for (size_t k = 0; k < scale->n; k++)
		if (*scale->tick[k].text && (y ? row_of : column_of)(s, &scale->tick[k]) == place)
			return &scale->tick[k];
	return NULL;
}

/* ---- lines of the screen */

static void add_cell(struct screen *s, int row, int column, int *colour)
{
	const size_t at = (size_t)(row * s->columns + column);
	const int dots = s->dots[at], series = dots ? s->series[at] : -1;

	if (series != *colour) {
		if (*colour >= 0)
			end_colour(s);
		if (series >= 0)
			begin_colour(s, (size_t)series);
		*colour = series;
	}
	if (!dots)
		ts_str_add(s->out, " ");
	else if (s->braille) /* U+2800 and up */
		ts_str_addf(s->out, "\xe2%c%c", (char)(0xa0 + dots / 64), (char)(0x80 + dots % 64));
	else
		ts_str_addf(s->out, "%c", series == MARK ? '.' : symbols[series % SYMBOLS]);
}

static void add_row(struct screen *s, int row, struct ts_str *text)
{
	const struct ts_plot_tick *tick = tick_at(s, &s->layout.y, row),
				  *right = tick_at(s, &s->layout.y2, row);
	int colour = -1;

	add_blanks(s, s->left - 1 - (tick ? tick_length(s, tick, text) : 0));
	ts_str_add(s->out, tick ? ts_str_text(text) : "");
	ts_str_add(s->out, s->unicode ? (tick ? "\u2524" : "\u2502") : tick ? "+" : "|");
	for (int k = 0; k < s->columns; k++)
		add_cell(s, row, k, &colour);
	if (colour >= 0)
		end_colour(s);
	if (s->layout.has_right)
		ts_str_add(s->out, s->unicode ? (right ? "\u251c" : "\u2502") : right ? "+" : "|");
	if (right && tick_length(s, right, text))
		ts_str_add(s->out, ts_str_text(text));
	ts_str_add(s->out, "\n");
}

static void add_axis(struct screen *s, struct ts_str *text)
{
	int at = 0; /* column of the next letter of the numbers, from the left of the screen */

	add_blanks(s, s->left - 1);
	ts_str_add(s->out, s->unicode ? "\u2514" : "+");
	for (int k = 0; k < s->columns; k++)
		if (tick_at(s, &s->layout.x, k))
			ts_str_add(s->out, s->unicode ? "\u252c" : "+");
		else
			ts_str_add(s->out, s->unicode ? "\u2500" : "-");
	if (s->layout.has_right)
		ts_str_add(s->out, s->unicode ? "\u2518" : "+");
	ts_str_add(s->out, "\n");
	for (int k = 0; k < s->columns; k++) {
		const struct ts_plot_tick *tick = tick_at(s, &s->layout.x, k);
		const int length = tick ? tick_length(s, tick, text) : 0;
		int from = s->left + k - length / 2;

		from = from + length > s->left + s->columns ? s->left + s->columns - length : from;
		if (!tick || from < at + (at > 0))
			continue;
		add_blanks(s, from - at);
		ts_str_add(s->out, ts_str_text(text));
		at = from + length;
	}
	ts_str_add(s->out, "\n");
}

static void add_line(struct screen *s, const char *text)
{
	if (!text || !*text)
		return;
	add_plain(s, text);
	ts_str_add(s->out, "\n");
}

/* Above the frame, of the right axis at the right; below each other if a line is too short. */
static void add_y_titles(struct screen *s)
{
	const struct ts_str *y = &s->layout.y_text, *right = &s->layout.right_text;
	const int width = s->left + s->columns + s->right,
		  length = (int)ts_plot_letters(ts_str_text(y), y->length),
		  other = (int)ts_plot_letters(ts_str_text(right), right->length);
	const bool fits = length + 2 + other <= width;

	if (!other || !fits)
		add_line(s, ts_str_text(y));
	if (!other)
		return;
	if (fits && length)
		add_plain(s, ts_str_text(y));
	add_blanks(s, width - other - (fits ? length : 0));
	add_line(s, ts_str_text(right));
}

/* At the right edge of the frame. */
static void add_x_title(struct screen *s)
{
	const int length = (int)ts_plot_letters(ts_str_text(&s->layout.x_text), s->layout.x_text.length);

	if (!length)
		return;
	add_blanks(s, s->left + s->columns - length);
	add_plain(s, ts_str_text(&s->layout.x_text));
	ts_str_add(s->out, "\n");
}

static void add_entry(struct screen *s, const char *sample, const char *name, bool *any)
{
	if (!name || !*name)
		return;
	ts_str_addf(s->out, "%s%s ", *any ? "   " : "", sample);
	add_plain(s, name);
	*any = true;
}

static void add_legend(struct screen *s)
{
	struct ts_str *out = s->out;
	bool any = false;

	for (size_t k = 0; k < s->plot->n; k++) {
		struct ts_str sample = { 0 };

		s->out = &sample;
		begin_colour(s, k);
		if (s->braille)
			ts_str_add(&sample, "\u2812\u2812");
		else
			ts_str_addf(&sample, "%c", symbols[k % SYMBOLS]);
		end_colour(s);
		s->out = out;
		add_entry(s, ts_str_text(&sample), s->plot->series[k].name, &any);
		out->failed |= sample.failed;
		ts_str_release(&sample);
	}
	for (size_t k = 0; k < s->plot->marks; k++)
		add_entry(s, s->braille ? "\u2804\u2804" : "...", s->plot->mark[k].name, &any);
	ts_str_add(out, any ? "\n" : "");
}

/* ---- the whole */

static int longest_tick(struct screen *s, const struct ts_plot_scale *scale, struct ts_str *text)
{
	int longest = 0;

	for (size_t k = 0; k < scale->n; k++) {
		const int length = tick_length(s, &scale->tick[k], text);

		longest = length > longest ? length : longest;
	}
	return longest;
}

/* Scales, then the room that their numbers leave. */
static void set_layout(struct screen *s, int columns)
{
	struct ts_plot_layout *l = &s->layout;
	struct ts_plot_extent extent;
	struct ts_str text = { 0 };

	ts_plot_extent(s->plot, &extent);
	ts_plot_scale_set(&l->y, s->plot, &extent, 1, s->rows / TICK_ROWS);
	s->left = longest_tick(s, &l->y, &text) + 1;
	l->has_right = ts_plot_has_right(s->plot);
	if (l->has_right) {
		ts_plot_scale_set(&l->y2, s->plot, &extent, 2, s->rows / TICK_ROWS);
		ts_plot_scale_title(&l->y2, &s->plot->right, &l->right_text);
		s->right = longest_tick(s, &l->y2, &text) + 1;
	}
	s->columns = columns - s->left - s->right;
	if (s->columns < 1) /* numbers fill the line */
		s->columns = 1;
	ts_plot_scale_set(&l->x, s->plot, &extent, 0, s->columns / TICK_COLUMNS);
	l->right = s->columns * s->across;
	l->bottom = s->rows * s->down;
	ts_plot_scale_title(&l->x, &s->plot->x, &l->x_text);
	ts_plot_scale_title(&l->y, &s->plot->y, &l->y_text);
	ts_plot_note(s->plot, &extent, &l->note_text);
	s->out->failed |= text.failed;
	ts_str_release(&text);
}

static enum ts_status draw(struct screen *s)
{
	struct ts_plot_trace trace = { 0 };
	enum ts_status status = TS_OK;

	for (size_t k = 0; k < s->plot->marks; k++)
		draw_mark(s, &s->plot->mark[k]);
	for (size_t k = 0; k < s->plot->n && status == TS_OK; k++)
		status = draw_series(s, k, &trace);
	ts_plot_trace_release(&trace);
	return status;
}

static void print(struct screen *s)
{
	struct ts_str text = { 0 };

	add_line(s, s->plot->title);
	add_legend(s);
	add_y_titles(s);
	for (int k = 0; k < s->rows; k++)
		add_row(s, k, &text);
	add_axis(s, &text);
	add_x_title(s);
	add_line(s, ts_str_text(&s->layout.note_text));
	s->out->failed |= text.failed;
	ts_str_release(&text);
}

enum ts_status ts_plot_terminal(const struct ts_plot *plot, const struct ts_plot_terminal *terminal,
				struct ts_str *out)
{
	const int columns = terminal->columns > LEAST_COLUMNS ? terminal->columns : LEAST_COLUMNS,
		  rows = (terminal->rows > LEAST_ROWS ? terminal->rows : LEAST_ROWS) - 4;
	struct screen s = { .plot = plot,
			    .unicode = terminal->unicode,
			    .colour = terminal->colour,
			    .braille = terminal->unicode && (plot->n < 2 || terminal->colour),
			    .rows = rows,
			    .out = out };
	enum ts_status status = TS_NOMEM;

	s.across = s.braille ? 2 : 1;
	s.down = s.braille ? 4 : 1;
	set_layout(&s, columns);
	s.dots = ts_alloc((size_t)(s.rows * s.columns), 1);
	s.series = ts_alloc((size_t)(s.rows * s.columns), 1);
	if (s.dots && s.series)
		status = draw(&s);
	if (status == TS_OK)
		print(&s);
	out->failed |= s.layout.x_text.failed || s.layout.y_text.failed || s.layout.right_text.failed ||
		       s.layout.note_text.failed;
	ts_free(s.dots);
	ts_free(s.series);
	ts_plot_layout_release(&s.layout);
	return status == TS_OK && out->failed ? TS_NOMEM : status;
}
