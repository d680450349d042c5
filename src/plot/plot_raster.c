#include "plot/plot_raster.h"

#include <math.h>
#include <string.h>

#include "plot/plot_ascii.h"
#include "plot/plot_canvas.h"
#include "render/letters.h"

#include "base/banned.h"

/* A dot of a letter is a unit. */
static const struct ts_plot_font FONT = { TS_LETTER_WIDTH, 15 };
static const double STROKE = 0.95, BOLD = 1.5; /* widths of strokes of letters, units */

struct raster {
	struct ts_plot_canvas base;
	struct ts_picture *picture;
	double scale, left, top; /* pixels to a unit; upper left corner of the plot in units */
	/* the path: width and dashes in units, colour mixed with what is there */
	double width, opacity, dash, gone; /* gone: length since the first dash */
	struct ts_colour colour;
	double x, y;
};

/* ---- strokes */

static void blend(struct ts_picture *p, int64_t x, int64_t y, struct ts_colour colour, double part)
{
	unsigned char *rgb = p->rgb + 3 * (y * p->width + x);

	for (int k = 0; k < 3; k++)
		rgb[k] = (unsigned char)lround((1 - part) * rgb[k] + part * 255 * (double)colour.c[k]);
}

static int64_t clamp_to(double x, int64_t most)
{
	return x < 0 ? 0 : x > (double)most ? most : (int64_t)x;
}

static double within(double part)
{
	return fmin(fmax(part, 0), 1);
}

/* A straight line with round ends: a pixel is covered by its distance from the middle line. */
static void stroke(const struct raster *r, double x0, double y0, double x1, double y1, double width)
{
	struct ts_picture *p = r->picture;
	const double s = r->scale, ax = s * (r->left + x0), ay = s * (r->top + y0), dx = s * (x1 - x0),
		     dy = s * (y1 - y0);
	const double half = 0.5 * fmax(s * width, 1), length2 = dx * dx + dy * dy, reach = half + 1;
	const int64_t top = clamp_to(fmin(ay, ay + dy) - reach, p->height),
		      bottom = clamp_to(fmax(ay, ay + dy) + reach + 1, p->height);

	for (int64_t y = top; y < bottom; y++) {
		const double py = (double)y + 0.5 - ay;
		/* the part of the line that is near this row */
		const double t0 = dy != 0 ? within((py - reach) / dy) : 0,
			     t1 = dy != 0 ? within((py + reach) / dy) : 1;
		const int64_t left = clamp_to(ax + fmin(t0 * dx, t1 * dx) - reach, p->width),
			      right = clamp_to(ax + fmax(t0 * dx, t1 * dx) + reach + 1, p->width);

		for (int64_t x = left; x < right; x++) {
			const double px = (double)x + 0.5 - ax;
			const double t = length2 > 0 ? within((px * dx + py * dy) / length2) : 0;
			const double cover = half + 0.5 - hypot(px - t * dx, py - t * dy);

			if (cover > 0)
				blend(p, x, y, r->colour, r->opacity * fmin(cover, 1));
		}
	}
}

static void begin(struct ts_plot_canvas *c, enum ts_plot_pen pen, size_t colour)
{
	static const struct {
		double width, opacity, dash;
	} pens[] = {
		[TS_PLOT_MINOR] = { 0.6, 0.1, 0 },  [TS_PLOT_GRID] = { 0.6, 0.25, 0 },
		[TS_PLOT_FRAME] = { 1, 0.6, 0 },    [TS_PLOT_CURVE] = { 1.5, 1, 0 },
		[TS_PLOT_THIN] = { 0.6, 1, 0 },	    [TS_PLOT_BAR] = { 1, 1, 0 },
		[TS_PLOT_DASHED] = { 1, 0.6, 4.5 },
	};
	struct raster *r = (struct raster *)c;

	r->width = pens[pen].width;
	r->opacity = pens[pen].opacity;
	r->dash = pens[pen].dash;
	r->colour = ts_colour_of_hex(colour == TS_PLOT_INK ? 0x222222 : ts_plot_colour(colour, false));
}

static void move(struct ts_plot_canvas *c, double x, double y)
{
	struct raster *r = (struct raster *)c;

	r->x = x;
	r->y = y;
	r->gone = 0;
}

static void line(struct ts_plot_canvas *c, double x, double y)
{
	struct raster *r = (struct raster *)c;
	const double dx = x - r->x, dy = y - r->y, length = hypot(dx, dy);

	if (!(r->dash > 0))
		stroke(r, r->x, r->y, x, y, r->width);
	for (double from = 0; r->dash > 0 && from < length; from += 2 * r->dash) {
		const double to = fmin(from + r->dash, length);

		stroke(r, r->x + dx * from / length, r->y + dy * from / length, r->x + dx * to / length,
		       r->y + dy * to / length, r->width);
	}
	r->x = x;
	r->y = y;
}

static void end(struct ts_plot_canvas *c)
{
	(void)c;
}

/* A polygon around a point, filled by strokes from its middle line to the outside. */
static void fill(const struct raster *r, double x, double y, size_t marker)
{
	static const double form[][4][2] = {
		{ { -2.5, -2.5 }, { 2.5, -2.5 }, { 2.5, 2.5 }, { -2.5, 2.5 } },
		{ { 0, -3 }, { 3, 2 }, { -3, 2 }, { 0, -3 } },
		{ { 0, -3.2 }, { 3.2, 0 }, { 0, 3.2 }, { -3.2, 0 } },
	};
	const double(*corner)[2] = form[marker - 1];
	enum { RINGS = 4 };

	for (int ring = 1; ring <= RINGS; ring++)
		for (int k = 0; k < 4; k++) {
			const double *a = corner[k], *b = corner[(k + 1) % 4], f = (double)ring / RINGS;

			stroke(r, x + f * a[0], y + f * a[1], x + f * b[0], y + f * b[1], 1);
		}
}

static void markers(struct ts_plot_canvas *c, const struct ts_plot_vertex *at, size_t n, size_t marker,
		    size_t colour)
{
	struct raster *r = (struct raster *)c;

	begin(c, TS_PLOT_CURVE, colour);
	for (size_t k = 0; k < n; k++) {
		if (marker == 0 || marker == TS_PLOT_FINE)
			stroke(r, at[k].x, at[k].y, at[k].x, at[k].y, marker ? 2 : 5.5);
		else
			fill(r, at[k].x, at[k].y, marker);
	}
}

/* ---- letters */

/* Strokes between the dots that touch; diagonal ones only where no dot lies beside them. */
static void draw_letter(const struct raster *r, double x, double y, double size, char letter, double width)
{
	for (int i = 0; i < 5; i++)
		for (int j = 0; j < TS_LETTER_ROWS; j++) {
			static const int step[4][2] = { { 1, 0 }, { 0, 1 }, { 1, 1 }, { -1, 1 } };
			const double px = x + size * (i + 0.5), py = y + size * (j + 0.5);

			if (!ts_letters_dot(letter, i, j))
				continue;
			stroke(r, px, py, px, py, width);
			for (int k = 0; k < 4; k++) {
				const int di = step[k][0], dj = step[k][1];

				if (!ts_letters_dot(letter, i + di, j + dj) ||
				    (di && dj &&
				     (ts_letters_dot(letter, i + di, j) ||
				      ts_letters_dot(letter, i, j + dj))))
					continue;
				stroke(r, px, py, px + size * di, py + size * dj, width);
			}
		}
}

static void text(struct ts_plot_canvas *c, double x, double y, enum ts_plot_align align,
		 enum ts_plot_letter kind, const char *words, size_t bytes)
{
	struct raster *r = (struct raster *)c;
	const char *stop = words + bytes;
	const double size = kind == TS_PLOT_SMALL ? 0.85 : 1;
	const double width = FONT.letter * size * (double)ts_plot_letters(words, bytes);

	r->colour = ts_colour_of_hex(0x222222);
	r->opacity = 1;
	x -= align == TS_PLOT_END ? width : align == TS_PLOT_MIDDLE ? 0.5 * width : 0;
	while (words < stop) {
		const struct ts_plot_ascii letter = ts_plot_ascii_next(&words, stop);
		const double small = letter.raised ? 0.75 : 1;

		draw_letter(r, x, y - (letter.raised ? 9.5 : 7) * size, size * small, letter.shown,
			    kind == TS_PLOT_BOLD ? BOLD : STROKE);
		x += FONT.letter * size * (letter.raised ? 0.8 : 1);
	}
}

/* ---- picture */

/* A white picture. */
static enum ts_status prepare(struct ts_picture *out, double width, double height)
{
	if (fmax(width, height) > TS_PICTURE_EDGE)
		return TS_RANGE;
	out->width = (uint32_t)ceil(width);
	out->height = (uint32_t)ceil(height);
	TS_TRY(TS_GROW(out->rgb, out->capacity, (size_t)3 * out->width * out->height));
	memset(out->rgb, 255, (size_t)3 * out->width * out->height);
	return TS_OK;
}

enum ts_status ts_plot_raster(const struct ts_plot *plot, double scale, struct ts_picture *out)
{
	return ts_plot_raster_panels(plot, 1, 1, scale, out);
}

enum ts_status ts_plot_raster_panels(const struct ts_plot *plot, size_t n, size_t columns, double scale,
				     struct ts_picture *out)
{
	struct raster r = { .base = { begin, move, line, end, markers, text },
			    .picture = out,
			    .scale = scale };
	struct ts_plot_panels p;
	enum ts_status status = ts_plot_panels_set(&p, plot, n, columns, &FONT);

	if (status == TS_OK)
		status = prepare(out, p.width * scale, p.height * scale);
	for (size_t k = 0; k < n && status == TS_OK; k++) {
		struct ts_plot_layout l;

		r.left = p.place[k][0];
		r.top = p.place[k][1];
		status = ts_plot_layout_set(&l, &plot[k], &FONT);
		if (status == TS_OK)
			status = ts_plot_canvas_draw(&r.base, &plot[k], &l);
		ts_plot_layout_release(&l);
	}
	ts_plot_panels_release(&p);
	return status;
}
