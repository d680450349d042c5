#include "plot/plot_svg.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "plot/plot_trace.h"

#include "base/banned.h"

static const struct ts_plot_font FONT = { 7.0, 17 }; /* of 13 units */

/* ---- texts */

/* Number of bytes of the letter of UTF-8 that begins here; 0: there is none, or XML does not permit it. */
static size_t letter_bytes(const unsigned char *c, size_t n)
{
	size_t bytes = *c < 0x80 ? 1 : *c >= 0xf0 && *c < 0xf5 ? 4 : *c >= 0xe0 ? 3 : *c >= 0xc2 ? 2 : 0;

	if (*c < 0x20 || *c == 0x7f || *c >= 0xf5 || bytes > n)
		return 0;
	for (size_t k = 1; k < bytes; k++)
		if ((c[k] & 0xc0) != 0x80)
			return 0;
	if ((*c == 0xe0 && c[1] < 0xa0) || (*c == 0xf0 && c[1] < 0x90) || (*c == 0xf4 && c[1] > 0x8f) ||
	    (*c == 0xed && c[1] > 0x9f) || (*c == 0xef && c[1] == 0xbf && c[2] > 0xbd))
		return 0;
	return bytes;
}

static void add_text(struct ts_str *out, const char *text, size_t n)
{
	for (size_t k = 0; k < n;) {
		const size_t bytes = letter_bytes((const unsigned char *)text + k, n - k);

		if (!bytes)
			ts_str_add(out, "\ufffd");
		else if (text[k] == '&')
			ts_str_add(out, "&amp;");
		else if (text[k] == '<')
			ts_str_add(out, "&lt;");
		else if (text[k] == '>')
			ts_str_add(out, "&gt;");
		else
			ts_str_add_n(out, text + k, bytes);
		k += bytes ? bytes : 1;
	}
}

/* ---- numbers: tenths of a unit, with no more letters than needed */

static int64_t tenths(double x)
{
	return llround(10 * x);
}

static void add_tenths(struct ts_str *out, int64_t value, bool first)
{
	const int64_t size = value < 0 ? -value : value;

	if (value < 0)
		ts_str_add(out, "-");
	else if (!first)
		ts_str_add(out, " ");
	if (size >= 10 || !size)
		ts_str_addf(out, "%" PRId64, size / 10);
	if (size % 10)
		ts_str_addf(out, ".%" PRId64, size % 10);
}

/* NAME="X" */
static void add_attribute(struct ts_str *out, const char *name, double x)
{
	ts_str_addf(out, " %s=\"", name);
	add_tenths(out, tenths(x), true);
	ts_str_add(out, "\"");
}

static void add_pair(struct ts_str *out, int64_t x, int64_t y)
{
	add_tenths(out, x, true);
	add_tenths(out, y, false);
}

static void move_to(struct ts_str *out, double x, double y)
{
	ts_str_add(out, "M");
	add_pair(out, tenths(x), tenths(y));
}

/* A text with its base line at x, y. */
static void add_label(struct ts_str *out, const char *class, double x, double y, const char *text, size_t n)
{
	ts_str_addf(out, "<text%s", class);
	add_attribute(out, "x", x);
	add_attribute(out, "y", y);
	ts_str_add(out, ">");
	add_text(out, text, n);
	ts_str_add(out, "</text>\n");
}

static void add_lines(struct ts_str *out, const struct ts_plot_lines *lines, const char *class, double x)
{
	for (int k = 0; k < lines->n; k++)
		add_label(out, class, x, lines->line[k].y, lines->line[k].text,
			  (size_t)lines->line[k].length);
}

/* ---- frame */

static void add_style(struct ts_str *out)
{
	ts_str_add(out,
		   "<style>.ts-plot{color:#222;font:13px system-ui,sans-serif;fill:currentColor}.ts-plot "
		   ".ground{fill:#fff}.ts-plot .t{font-weight:bold}.ts-plot .m{text-anchor:middle}.ts-plot "
		   ".e{text-anchor:end}.ts-plot .small{font-size:11px}.ts-plot "
		   "path{fill:none;stroke:currentColor;stroke-width:1.5;stroke-linecap:round;stroke-linejoin:"
		   "round}.ts-plot .grid{stroke-width:.6;opacity:.25}.ts-plot "
		   ".minor{stroke-width:.6;opacity:.1}.ts-plot .frame{stroke-width:1;opacity:.6}.ts-plot "
		   ".mark{stroke-width:1.2;stroke-dasharray:5 4;opacity:.8}.ts-plot "
		   ".dot{stroke-width:5.5}.ts-plot .fine{stroke-width:2}.ts-plot "
		   ".solid{fill:currentColor;stroke-width:1}.ts-plot .bar{stroke-width:1}");
	for (int dark = 0; dark < 2; dark++) {
		if (dark)
			ts_str_add(out, "@media screen and "
					"(prefers-color-scheme:dark){.ts-plot{color:#ddd}.ts-plot "
					".ground{fill:#16181c}");
		for (size_t k = 0; k < TS_PLOT_COLOURS; k++)
			ts_str_addf(out, ".ts-plot .c%zu{color:#%06x}", k + 1, ts_plot_colour(k, dark));
	}
	ts_str_add(out, "}</style>\n");
}

static void add_grid(struct ts_str *out, const struct ts_plot_layout *l, bool minor)
{
	size_t lines = 0;

	for (int axis = 0; axis < 2; axis++) {
		const struct ts_plot_scale *scale = axis ? &l->y : &l->x;

		for (size_t k = 0; k < scale->n; k++) {
			const double at = scale->tick[k].at;

			if (!*scale->tick[k].text != minor)
				continue;
			if (!lines++)
				ts_str_addf(out, "<path class=\"%s\" d=\"", minor ? "minor" : "grid");
			if (axis) {
				move_to(out, l->left, l->bottom - at * (l->bottom - l->top));
				ts_str_add(out, "H");
				add_tenths(out, tenths(l->right), true);
			} else {
				move_to(out, l->left + at * (l->right - l->left), l->top);
				ts_str_add(out, "V");
				add_tenths(out, tenths(l->bottom), true);
			}
		}
	}
	ts_str_add(out, lines ? "\"/>\n" : "");
}

static void add_tick_texts(struct ts_str *out, const struct ts_plot_layout *l)
{
	for (int axis = 0; axis < 2; axis++) {
		const struct ts_plot_scale *scale = axis ? &l->y : &l->x;

		ts_str_addf(out, "<g class=\"%s\">\n", axis ? "e" : "m");
		for (size_t k = 0; k < scale->n; k++) {
			const double at = scale->tick[k].at;
			struct ts_str text = { 0 };

			ts_plot_scale_pretty(scale->tick[k].text, &text);
			if (text.length)
				add_label(out, "", axis ? l->left - 6 : l->left + at * (l->right - l->left),
					  axis ? l->bottom - at * (l->bottom - l->top) + 4.5
					       : l->bottom + 6 + 0.75 * l->font.line,
					  text.text, text.length);
			out->failed |= text.failed;
			ts_str_release(&text);
		}
		ts_str_add(out, "</g>\n");
	}
}

/* Left and lower edge. */
static void add_frame(struct ts_str *out, const struct ts_plot_layout *l)
{
	ts_str_add(out, "<path class=\"frame\" d=\"");
	move_to(out, l->left, l->top);
	ts_str_add(out, "V");
	add_tenths(out, tenths(l->bottom), true);
	ts_str_add(out, "H");
	add_tenths(out, tenths(l->right), true);
	ts_str_add(out, "\"/>\n");
}

/* ---- curves */

static void add_curve(struct ts_str *out, const struct ts_plot_trace *t)
{
	int64_t x = 0, y = 0;

	if (!t->n)
		return;
	ts_str_add(out, "<path d=\"");
	for (size_t k = 0; k < t->n; k++) {
		const int64_t px = tenths(t->vertex[k].x), py = tenths(t->vertex[k].y);

		if (t->vertex[k].begins) {
			ts_str_add(out, "M");
			add_pair(out, px, py);
		} else if (px == x && py == y) {
			ts_str_add(out, t->vertex[k - 1].begins ? "h0" : "");
		} else {
			ts_str_add(out, "l");
			add_pair(out, px - x, py - y);
		}
		x = px;
		y = py;
	}
	ts_str_add(out, "\"/>\n");
}

/* Discs are lines without length and with round ends; behind the markers the small dot of a
 * crowd. */
static void add_marker(struct ts_str *out, size_t marker, double x, double y)
{
	static const char *const form[] = { "h0", "m-2.5-2.5h5v5h-5z", "m0-3l3 5h-6z",
					    "m0-3.2l3.2 3.2-3.2 3.2-3.2-3.2z", "h0" };

	move_to(out, x, y);
	ts_str_add(out, form[marker]);
}

static void begin_markers(struct ts_str *out, size_t marker)
{
	static const char *const class[] = { "dot", "solid", "solid", "solid", "fine" };

	ts_str_addf(out, "<path class=\"%s\" d=\"", class[marker]);
}

static void add_markers(struct ts_str *out, const struct ts_plot_trace *t, size_t marker)
{
	if (!t->n)
		return;
	if (t->n > TS_PLOT_CROWD)
		marker = TS_PLOT_MARKERS;
	begin_markers(out, marker);
	for (size_t k = 0; k < t->n; k++)
		add_marker(out, marker, t->vertex[k].x, t->vertex[k].y);
	ts_str_add(out, "\"/>\n");
}

static void add_error_bars(struct ts_str *out, const struct ts_plot_layout *l, const struct ts_plot_series *s,
			   const struct ts_plot_trace *t)
{
	size_t bars = 0;

	for (size_t k = 0; k < t->n; k++) {
		double top, bottom;

		if (!ts_plot_error_bar(l, s, t->vertex[k].point, &top, &bottom))
			continue;
		ts_str_add(out, bars++ ? "" : "<path class=\"bar\" d=\"");
		move_to(out, t->vertex[k].x - 3, top);
		ts_str_add(out, "h6m-3 0V");
		add_tenths(out, tenths(bottom), true);
		ts_str_add(out, "m-3 0h6");
	}
	ts_str_add(out, bars ? "\"/>\n" : "");
}

static enum ts_status add_series(struct ts_str *out, const struct ts_plot_layout *l,
				 const struct ts_plot *plot, size_t k, struct ts_plot_trace *t)
{
	const struct ts_plot_series *s = &plot->series[k];

	ts_str_addf(out, "<g class=\"c%zu\">\n", ts_plot_colour_of(plot, k) + 1);
	if (ts_plot_has_line(s)) {
		TS_TRY(ts_plot_trace_line(t, l, s));
		add_curve(out, t);
	}
	TS_TRY(ts_plot_trace_points(t, l, s));
	add_error_bars(out, l, s, t);
	add_markers(out, t, ts_plot_marker_of(plot, k));
	ts_str_add(out, "</g>\n");
	return TS_OK;
}

static void add_legend(struct ts_str *out, const struct ts_plot_layout *l, const struct ts_plot *plot)
{
	for (size_t k = 0; k < plot->n; k++) {
		const struct ts_plot_series *s = &plot->series[k];
		const double x = l->entry[k].x, y = l->entry[k].y - 4.5;

		if (!s->name || !*s->name)
			continue;
		ts_str_addf(out, "<g class=\"c%zu\">", ts_plot_colour_of(plot, k) + 1);
		if (ts_plot_has_line(s)) {
			ts_str_add(out, "<path d=\"");
			move_to(out, x, y);
			ts_str_add(out, "h20\"/>");
		}
		if (ts_plot_has_points(s)) {
			begin_markers(out, ts_plot_marker_of(plot, k));
			add_marker(out, ts_plot_marker_of(plot, k), x + 10, y);
			ts_str_add(out, "\"/>");
		}
		ts_str_add(out, "</g>");
		add_label(out, "", x + TS_PLOT_SAMPLE, l->entry[k].y, s->name, strlen(s->name));
	}
}

static void add_mark(struct ts_str *out, const struct ts_plot_layout *l, const struct ts_plot_mark *mark)
{
	const double at = ts_plot_scale_at(mark->vertical ? &l->x : &l->y, mark->at);
	const double x = mark->vertical ? l->left + at * (l->right - l->left) : l->right,
		     y = mark->vertical ? l->top : l->bottom - at * (l->bottom - l->top);

	if (!(at >= 0 && at <= 1))
		return;
	ts_str_add(out, "<path class=\"mark\" d=\"");
	move_to(out, mark->vertical ? x : l->left, y);
	ts_str_add(out, mark->vertical ? "V" : "H");
	add_tenths(out, tenths(mark->vertical ? l->bottom : l->right), true);
	ts_str_add(out, "\"/>\n");
	if (mark->name) /* inside of the frame */
		add_label(out, !mark->vertical || at > 0.5 ? " class=\"e small\"" : " class=\"small\"",
			  mark->vertical ? x + (at > 0.5 ? -4 : 4) : x - 2,
			  mark->vertical ? y + 11 : y - 4 + (at > 0.9 ? 16 : 0), mark->name,
			  strlen(mark->name));
}

static void add_head(struct ts_str *out, const struct ts_plot_layout *l, const struct ts_plot *plot)
{
	ts_str_add(out,
		   "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"ts-plot\" role=\"img\" viewBox=\"0 0 ");
	add_pair(out, tenths(l->width), tenths(l->height));
	ts_str_add(out, "\">\n");
	if (plot->title) {
		ts_str_add(out, "<title>");
		add_text(out, plot->title, strlen(plot->title));
		ts_str_add(out, "</title>\n");
	}
	add_style(out);
	ts_str_add(out, "<rect class=\"ground\" width=\"100%\" height=\"100%\"/>\n");
}

enum ts_status ts_plot_svg_add(const struct ts_plot *plot, struct ts_str *out)
{
	struct ts_plot_layout layout, *l = &layout;
	struct ts_plot_trace trace = { 0 };
	enum ts_status status = ts_plot_layout_set(l, plot, &FONT);

	if (status == TS_OK) {
		add_head(out, l, plot);
		add_grid(out, l, true);
		add_grid(out, l, false);
		add_frame(out, l);
		for (size_t k = 0; k < plot->n && status == TS_OK; k++)
			status = add_series(out, l, plot, k, &trace);
		for (size_t k = 0; k < plot->marks; k++)
			add_mark(out, l, &plot->mark[k]);
		add_legend(out, l, plot);
		add_tick_texts(out, l);
		add_lines(out, &l->title, " class=\"t\"", 8);
		add_lines(out, &l->y_title, "", 8);
		add_lines(out, &l->x_title, " class=\"e\"", l->right);
		add_lines(out, &l->note, " class=\"small\"", 8);
		ts_str_add(out, "</svg>\n");
	}
	ts_plot_trace_release(&trace);
	ts_plot_layout_release(l);
	return status == TS_OK && out->failed ? TS_NOMEM : status;
}

enum ts_status ts_plot_svg(const struct ts_plot *plot, FILE *out)
{
	struct ts_str text = { 0 };
	enum ts_status status = ts_plot_svg_add(plot, &text);

	if (status == TS_OK && fwrite(text.text, 1, text.length, out) != text.length)
		status = TS_IO;
	ts_str_release(&text);
	return status;
}
