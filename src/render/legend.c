#include "render/legend.h"

#include <math.h>
#include <stdio.h>

#include "render/letters.h"

#include "base/banned.h"

enum { TICKS = 5, WIDE = 400, HIGH = 260 /* size of the picture for which a dot is a pixel */ };
static const double VEIL = 0.8; /* of the ground, between the scene and the legend */

/* Pixels to a dot. */
static int scale_of(const struct ts_picture *p)
{
	const int x = (int)((p->width + WIDE / 2) / WIDE), y = (int)((p->height + HIGH / 2) / HIGH);
	const int least = x < y ? x : y;

	return least > 1 ? least : 1;
}

/* Numbers that are nothing beside the range are zero. */
static double rounded(double value, double range)
{
	return fabs(value) < 1e-6 * range ? 0 : value;
}

void ts_legend_draw(struct ts_picture *p, enum ts_legend_side side, const struct ts_colour_map *map,
		    double lo, double hi, const char *title, struct ts_colour ink, struct ts_colour ground)
{
	const int scale = scale_of(p), line = TS_LETTER_HEIGHT * scale;
	const int64_t height = (int64_t)p->height * 6 / 10, top = ((int64_t)p->height - height) / 2,
		      width = 2 * line;
	const int64_t named = ts_letters_width(title, scale);
	int64_t widest = 0, left, begin, panel;
	char text[TICKS][24];

	for (int k = 0; k < TICKS; k++) {
		const double part = (double)k / (TICKS - 1);

		snprintf(text[k], sizeof text[k], "%.3g", rounded((1 - part) * hi + part * lo, hi - lo));
		widest =
			ts_letters_width(text[k], scale) > widest ? ts_letters_width(text[k], scale) : widest;
	}
	left = side == TS_LEGEND_LEFT ? line : (int64_t)p->width - widest - width - 2 * line;
	/* the title begins at the left edge or ends at the right one */
	begin = side == TS_LEGEND_LEFT ? line : (int64_t)p->width - line - named;
	begin = begin > line ? begin : line;
	panel = width + widest + 2 * line > named ? width + widest + 2 * line : named + line;
	ts_letters_veil(p, side == TS_LEGEND_LEFT ? 0 : (int64_t)p->width - panel - line, top - 3 * line,
			panel + line, height + 4 * line, ground, VEIL);
	ts_letters_fill(p, left - scale, top - scale, width + 2 * scale, height + 2 * scale, ink);
	for (int64_t y = 0; y < height; y++) {
		const double part = height > 1 ? (double)y / (double)(height - 1) : 0;

		ts_letters_fill(p, left, top + y, width, 1,
				ts_colour_map_at(map, lo, hi, (1 - part) * hi + part * lo));
	}
	for (int k = 0; k < TICKS; k++) {
		const int64_t y = top + (height - 1) * k / (TICKS - 1);

		ts_letters_fill(p, left + width + scale, y, 2 * scale, scale, ink);
		ts_letters_draw(p, left + width + 6 * scale, y - 3 * scale, scale, text[k], ink);
	}
	ts_letters_draw(p, begin, top - 2 * line, scale, title, ink);
}
