#include "plot/plot_layout.h"

#include <math.h>
#include <string.h>

#include "base/banned.h"

enum {
	WIDTH = 480,
	HEIGHT = 320,
	LEAST = 160,
	EDGE = 8,
	GAP = 6,
	TICK_SPACE = 62 /* units for a number on the x axis */
};

size_t ts_plot_letters(const char *text, size_t bytes)
{
	size_t n = 0;

	for (size_t k = 0; k < bytes; k++)
		n += ((unsigned char)text[k] & 0xc0) != 0x80; /* not the rest of a letter of UTF-8 */
	return n;
}

static double text_width(const struct ts_plot_layout *l, const char *text)
{
	return l->font.letter * (double)ts_plot_letters(text, strlen(text));
}

/* Bytes of the text that fit into the width: whole words if there is a blank. */
static size_t fitting(const char *text, size_t most_letters)
{
	size_t bytes = 0, letters = 0, words = 0;

	for (; text[bytes]; bytes++) {
		letters += ((unsigned char)text[bytes] & 0xc0) != 0x80;
		if (letters > most_letters)
			return words ? words : bytes;
		if (text[bytes] == ' ')
			words = bytes;
	}
	return bytes;
}

/* Breaks the text; returns the height. The last line may be too long. */
static double break_text(const struct ts_plot_layout *l, struct ts_plot_lines *out, const char *text,
			 double width)
{
	const double most = fmax(width / l->font.letter, 8);

	out->n = 0;
	while (text && *text && out->n < TS_PLOT_TEXT_LINES) {
		const size_t n = out->n + 1 < TS_PLOT_TEXT_LINES ? fitting(text, (size_t)most) : strlen(text);

		out->line[out->n].text = text;
		out->line[out->n++].length = (int)n;
		text += n;
		text += *text == ' ';
	}
	return out->n * l->font.line;
}

/* Sets the base lines below `top`; returns the lower edge. */
static double place_text(const struct ts_plot_layout *l, struct ts_plot_lines *out, double top)
{
	for (int k = 0; k < out->n; k++)
		out->line[k].y = top + (k + 0.75) * l->font.line;
	return top + out->n * l->font.line;
}

/* Entries side by side as far as they fit; returns the lower edge. */
static double place_legend(struct ts_plot_layout *l, const struct ts_plot *plot, double top)
{
	double x = EDGE, y = top + 0.75 * l->font.line;
	bool any = false;

	for (size_t k = 0; k < plot->n; k++) {
		const char *name = plot->series[k].name;
		double width;

		if (!name || !*name)
			continue;
		width = TS_PLOT_SAMPLE + text_width(l, name) + 2 * GAP;
		if (any && x > EDGE && x + width > l->width - EDGE) {
			x = EDGE;
			y += l->font.line;
		}
		l->entry[k] = (struct ts_plot_entry){ x, y };
		x += width;
		any = true;
	}
	return any ? y + 0.25 * l->font.line : top;
}

static double widest_tick(struct ts_plot_layout *l, const struct ts_plot_scale *scale)
{
	double widest = 0;

	for (size_t k = 0; k < scale->n; k++) {
		struct ts_str text = { 0 };

		ts_plot_scale_pretty(scale->tick[k].text, &text);
		widest = fmax(widest, text_width(l, ts_str_text(&text)));
		l->note_text.failed |= text.failed;
		ts_str_release(&text);
	}
	return widest;
}

void ts_plot_note(const struct ts_plot *plot, const struct ts_plot_extent *extent, struct ts_str *out)
{
	if (!extent->points)
		ts_str_add(out, "no data");
	else if (extent->hidden)
		ts_str_addf(out, "%zu of %zu points not shown: not finite%s", extent->hidden, extent->points,
			    plot->x.log || plot->y.log || plot->right.log
				    ? ", or not positive on a logarithmic axis"
				    : "");
}

/* Room for the title of one y axis beside that of the other one: half of it, and what that does not need. */
static double room_beside(const struct ts_plot_layout *l, const struct ts_str *other, double most)
{
	return l->has_right ? fmax(0.5 * most - GAP, most - text_width(l, ts_str_text(other)) - 2 * GAP)
			    : most;
}

static void set_scales(struct ts_plot_layout *l, const struct ts_plot *plot,
		       const struct ts_plot_extent *extent, double least)
{
	const int ticks = (int)(least / (1.5 * l->font.line)) + 1;
	double widest, beside = 0;

	ts_plot_scale_set(&l->y, plot, extent, 1, ticks);
	l->left = EDGE + widest_tick(l, &l->y) + GAP;
	l->has_right = ts_plot_has_right(plot);
	if (l->has_right) {
		ts_plot_scale_set(&l->y2, plot, extent, 2, ticks);
		beside = widest_tick(l, &l->y2) + GAP;
	}
	ts_plot_scale_set(&l->x, plot, extent, 0, (int)((l->width - EDGE - l->left - beside) / TICK_SPACE));
	widest = widest_tick(l, &l->x);
	l->left = fmax(l->left, EDGE + 0.5 * widest);
	l->right = l->width - EDGE - fmax(fmin(0.5 * widest, TICK_SPACE), beside);
}

static void place(struct ts_plot_layout *l, const struct ts_plot *plot, const struct ts_plot_extent *extent)
{
	const double most = l->width - 2 * EDGE, line = l->font.line;
	const double least = 0.5 * l->height; /* height of the frame */
	double below;

	set_scales(l, plot, extent, least);
	ts_plot_scale_title(&l->x, &plot->x, &l->x_text);
	ts_plot_scale_title(&l->y, &plot->y, &l->y_text);
	if (l->has_right)
		ts_plot_scale_title(&l->y2, &plot->right, &l->right_text);
	ts_plot_note(plot, extent, &l->note_text);

	break_text(l, &l->title, plot->title, most * (1 - 0.15)); /* is bold */
	break_text(l, &l->y_title, ts_str_text(&l->y_text), room_beside(l, &l->right_text, most));
	break_text(l, &l->right_title, ts_str_text(&l->right_text), room_beside(l, &l->y_text, most));
	below = GAP + line + break_text(l, &l->x_title, ts_str_text(&l->x_text), most) +
		break_text(l, &l->note, ts_str_text(&l->note_text), most) + EDGE;
	l->top = place_text(l, &l->title, EDGE);
	l->top = place_legend(l, plot, l->top + (l->title.n ? GAP / 2 : 0));
	l->top = fmax(place_text(l, &l->y_title, l->top), place_text(l, &l->right_title, l->top)) + GAP;
	if (l->top == EDGE + GAP) /* nothing above: half a number of the y axis */
		l->top += 0.25 * line;
	l->height = fmax(l->height, l->top + least + below);
	l->bottom = l->height - below;
	place_text(l, &l->note, place_text(l, &l->x_title, l->bottom + GAP + line));
}

enum ts_status ts_plot_layout_set(struct ts_plot_layout *l, const struct ts_plot *plot,
				  const struct ts_plot_font *font)
{
	struct ts_plot_extent extent;

	*l = (struct ts_plot_layout){ .font = *font,
				      .width = plot->width > 0 ? fmax(plot->width, LEAST) : WIDTH,
				      .height = plot->height > 0 ? fmax(plot->height, LEAST) : HEIGHT };
	l->entry = ts_alloc(plot->n, sizeof *l->entry);
	if (!l->entry)
		return TS_NOMEM;
	ts_plot_extent(plot, &extent);
	place(l, plot, &extent);
	return l->x_text.failed || l->y_text.failed || l->right_text.failed || l->note_text.failed ? TS_NOMEM
												   : TS_OK;
}

const struct ts_plot_scale *ts_plot_layout_scale(const struct ts_plot_layout *l,
						 const struct ts_plot_series *s)
{
	return s->right ? &l->y2 : &l->y;
}

void ts_plot_layout_release(struct ts_plot_layout *l)
{
	ts_free(l->entry);
	ts_str_release(&l->x_text);
	ts_str_release(&l->y_text);
	ts_str_release(&l->right_text);
	ts_str_release(&l->note_text);
	*l = (struct ts_plot_layout){ 0 };
}

enum ts_status ts_plot_panels_set(struct ts_plot_panels *p, const struct ts_plot *plot, size_t n,
				  size_t columns, const struct ts_plot_font *font)
{
	double x = 0, y = 0, row = 0; /* next place, height of the row */

	*p = (struct ts_plot_panels){ .place = ts_alloc(n, sizeof *p->place) };
	if (!p->place)
		return TS_NOMEM;
	for (size_t k = 0; k < n; k++) {
		struct ts_plot_layout l;
		enum ts_status status = ts_plot_layout_set(&l, &plot[k], font);

		if (k % columns == 0) {
			x = 0;
			y += row;
			row = 0;
		}
		p->place[k][0] = x;
		p->place[k][1] = y;
		x += l.width;
		row = fmax(row, l.height);
		p->width = fmax(p->width, x);
		p->height = fmax(p->height, y + l.height);
		ts_plot_layout_release(&l);
		TS_TRY(status);
	}
	return TS_OK;
}

void ts_plot_panels_release(struct ts_plot_panels *p)
{
	ts_free(p->place);
	*p = (struct ts_plot_panels){ 0 };
}
