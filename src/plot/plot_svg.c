#include "plot/plot_svg.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "plot/plot_canvas.h"

#include "base/banned.h"

static const struct ts_plot_font FONT = { 7.5, 17 }; /* of 13 units; sans-serif fonts have 6.5 to 7.8 */

struct svg {
	struct ts_plot_canvas base;
	struct ts_str *out;
	enum ts_plot_pen pen;
	size_t colour;
	int64_t x, y;	  /* last place in tenths of a unit */
	bool open, fresh; /* the path has been opened; nothing is drawn since the last move */
};

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

static void add_text(struct ts_str *out, const char *words, size_t n)
{
	for (size_t k = 0; k < n;) {
		const size_t bytes = letter_bytes((const unsigned char *)words + k, n - k);

		if (!bytes)
			ts_str_add(out, "\ufffd");
		else if (words[k] == '&')
			ts_str_add(out, "&amp;");
		else if (words[k] == '<')
			ts_str_add(out, "&lt;");
		else if (words[k] == '>')
			ts_str_add(out, "&gt;");
		else
			ts_str_add_n(out, words + k, bytes);
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

static void add_pair(struct ts_str *out, int64_t x, int64_t y)
{
	add_tenths(out, x, true);
	add_tenths(out, y, false);
}

/* NAME="X" */
static void add_attribute(struct ts_str *out, const char *name, double x)
{
	ts_str_addf(out, " %s=\"", name);
	add_tenths(out, tenths(x), true);
	ts_str_add(out, "\"");
}

/* ---- canvas */

static void begin(struct ts_plot_canvas *c, enum ts_plot_pen pen, size_t colour)
{
	struct svg *s = (struct svg *)c;

	s->pen = pen;
	s->colour = colour;
	s->open = false;
}

/* <path class="c1 bar" d=" */
static void open_path(struct svg *s, const char *class)
{
	ts_str_add(s->out, "<path class=\"");
	if (s->colour != TS_PLOT_INK)
		ts_str_addf(s->out, "c%zu%s", s->colour + 1, *class ? " " : "");
	ts_str_addf(s->out, "%s\" d=\"", class);
	s->open = true;
}

static void move(struct ts_plot_canvas *c, double x, double y)
{
	static const char *const class[] = {
		[TS_PLOT_MINOR] = "minor", [TS_PLOT_GRID] = "grid", [TS_PLOT_FRAME] = "frame",
		[TS_PLOT_CURVE] = "",	   [TS_PLOT_THIN] = "thin", [TS_PLOT_BAR] = "bar",
		[TS_PLOT_DASHED] = "mark",
	};
	struct svg *s = (struct svg *)c;

	if (!s->open)
		open_path(s, class[s->pen]);
	s->x = tenths(x);
	s->y = tenths(y);
	s->fresh = true;
	ts_str_add(s->out, "M");
	add_pair(s->out, s->x, s->y);
}

static void line(struct ts_plot_canvas *c, double x, double y)
{
	struct svg *s = (struct svg *)c;
	const int64_t dx = tenths(x) - s->x, dy = tenths(y) - s->y;

	if (dy && dx) {
		ts_str_add(s->out, "l");
		add_pair(s->out, dx, dy);
	} else if (dy || dx || s->fresh) {
		ts_str_add(s->out, dy ? "v" : "h");
		add_tenths(s->out, dy ? dy : dx, true);
	}
	s->x += dx;
	s->y += dy;
	s->fresh = false;
}

static void end(struct ts_plot_canvas *c)
{
	struct svg *s = (struct svg *)c;

	if (s->open)
		ts_str_add(s->out, "\"/>\n");
	s->open = false;
}

/* Discs are lines without length and with round ends. */
static void markers(struct ts_plot_canvas *c, const struct ts_plot_vertex *at, size_t n, size_t marker,
		    size_t colour)
{
	static const struct {
		const char *class, *form;
	} list[] = { { "dot", "h0" },
		     { "solid", "m-2.5-2.5h5v5h-5z" },
		     { "solid", "m0-3l3 5h-6z" },
		     { "solid", "m0-3.2l3.2 3.2-3.2 3.2-3.2-3.2z" },
		     [TS_PLOT_FINE] = { "fine", "h0" } };
	struct svg *s = (struct svg *)c;

	begin(c, TS_PLOT_CURVE, colour);
	open_path(s, list[marker].class);
	for (size_t k = 0; k < n; k++) {
		move(c, at[k].x, at[k].y);
		ts_str_add(s->out, list[marker].form);
	}
	end(c);
}

static void text(struct ts_plot_canvas *c, double x, double y, enum ts_plot_align align,
		 enum ts_plot_letter letter, const char *words, size_t bytes)
{
	static const char *const aligned[] = { "", "m", "e" }, *const kind[] = { "", "t", "small" };
	struct svg *s = (struct svg *)c;

	ts_str_add(s->out, "<text");
	if (align != TS_PLOT_START || letter != TS_PLOT_NORMAL)
		ts_str_addf(s->out, " class=\"%s%s%s\"", aligned[align],
			    align != TS_PLOT_START && letter != TS_PLOT_NORMAL ? " " : "", kind[letter]);
	add_attribute(s->out, "x", x);
	add_attribute(s->out, "y", y);
	ts_str_add(s->out, ">");
	add_text(s->out, words, bytes);
	ts_str_add(s->out, "</text>\n");
}

/* ---- picture */

static void add_colours(struct ts_str *out, bool dark)
{
	for (size_t k = 0; k < TS_PLOT_COLOURS; k++)
		ts_str_addf(out, ".ts-plot .c%zu{color:#%06x}", k + 1, ts_plot_colour(k, dark));
}

static void add_style(struct ts_str *out)
{
	static const char *const rules[] = {
		"{color:#222;font:13px system-ui,sans-serif;fill:currentColor}",
		" .ground{fill:#fff}",
		" .t{font-weight:bold}",
		" .m{text-anchor:middle}",
		" .e{text-anchor:end}",
		" .small{font-size:11px}",
		" path{fill:none;stroke:currentColor;stroke-width:1.5}",
		" path{stroke-linecap:round;stroke-linejoin:round}",
		" .grid{stroke-width:.6;opacity:.25}",
		" .minor{stroke-width:.6;opacity:.1}",
		" .frame{stroke-width:1;opacity:.6}",
		" .mark{stroke-width:1;stroke-dasharray:5 4;opacity:.6}",
		" .thin{stroke-width:.6}",
		" .bar{stroke-width:1}",
		" .dot{stroke-width:5.5}",
		" .fine{stroke-width:2}",
		" .solid{fill:currentColor;stroke-width:1}",
	};

	ts_str_add(out, "<style>");
	for (size_t k = 0; k < sizeof rules / sizeof *rules; k++)
		ts_str_addf(out, ".ts-plot%s", rules[k]);
	add_colours(out, false);
	ts_str_add(out, "@media screen and (prefers-color-scheme:dark){");
	ts_str_add(out, ".ts-plot{color:#ddd}.ts-plot .ground{fill:#16181c}");
	add_colours(out, true);
	ts_str_add(out, "}</style>\n");
}

/* With `place`: a picture within another one, at this place. */
static void add_head(struct ts_str *out, const struct ts_plot *plot, double width, double height,
		     const double *place)
{
	ts_str_add(out, place ? "<svg"
			      : "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"ts-plot\" role=\"img\"");
	if (place) {
		add_attribute(out, "x", place[0]);
		add_attribute(out, "y", place[1]);
		add_attribute(out, "width", width);
		add_attribute(out, "height", height);
	}
	ts_str_add(out, " viewBox=\"0 0 ");
	add_pair(out, tenths(width), tenths(height));
	ts_str_add(out, "\">\n");
	if (plot->title) {
		ts_str_add(out, "<title>");
		add_text(out, plot->title, strlen(plot->title));
		ts_str_add(out, "</title>\n");
	}
	if (place)
		return;
	add_style(out);
	ts_str_add(out, "<rect class=\"ground\" width=\"100%\" height=\"100%\"/>\n");
}

static enum ts_status add_plot(struct ts_str *out, const struct ts_plot *plot, const double *place)
{
	struct svg s = { { begin, move, line, end, markers, text }, .out = out };
	struct ts_plot_layout l;
	enum ts_status status = ts_plot_layout_set(&l, plot, &FONT);

	if (status == TS_OK) {
		add_head(out, plot, l.width, l.height, place);
		status = ts_plot_canvas_draw(&s.base, plot, &l);
		ts_str_add(out, "</svg>\n");
	}
	ts_plot_layout_release(&l);
	return status == TS_OK && out->failed ? TS_NOMEM : status;
}

enum ts_status ts_plot_svg_add(const struct ts_plot *plot, struct ts_str *out)
{
	return add_plot(out, plot, NULL);
}

enum ts_status ts_plot_svg_panels(const struct ts_plot *plot, size_t n, size_t columns, struct ts_str *out)
{
	struct ts_plot_panels p;
	enum ts_status status;

	if (n == 1)
		return ts_plot_svg_add(plot, out);
	status = ts_plot_panels_set(&p, plot, n, columns, &FONT);
	if (status == TS_OK)
		add_head(out, &(struct ts_plot){ 0 }, p.width, p.height, NULL);
	for (size_t k = 0; k < n && status == TS_OK; k++)
		status = add_plot(out, &plot[k], p.place[k]);
	ts_str_add(out, "</svg>\n");
	ts_plot_panels_release(&p);
	return status == TS_OK && out->failed ? TS_NOMEM : status;
}

enum ts_status ts_plot_svg(const struct ts_plot *plot, FILE *out)
{
	struct ts_str bytes = { 0 };
	enum ts_status status = ts_plot_svg_add(plot, &bytes);

	if (status == TS_OK && fwrite(bytes.text, 1, bytes.length, out) != bytes.length)
		status = TS_IO;
	ts_str_release(&bytes);
	return status;
}
