#include "plot/plot.h"

#include <math.h>

#include "base/banned.h"

enum { FEW = 40 };
/* Beyond it the width of a range is no number. */
static const double LARGEST = 1e300, LEAST = 1e-300;

unsigned ts_plot_colour(size_t k, bool dark)
{
	/* blue, vermilion, bluish green, reddish purple, orange, sky blue, ink; on a dark ground all lighter */
	static const unsigned colour[2][TS_PLOT_COLOURS] = {
		{ 0x005191, 0xb33e17, 0x00ab61, 0xad6186, 0xd77f00, 0x5a7ef1, 0x333333 },
		{ 0x3586e1, 0xe36e2f, 0x4be385, 0xd37eb0, 0xf8ca35, 0xa4d1ff, 0xdddddd },
	};

	return colour[dark][k % TS_PLOT_COLOURS];
}

size_t ts_plot_colour_of(const struct ts_plot *plot, size_t series)
{
	const int own = plot->series[series].colour;

	return (own > 0 ? (size_t)own - 1 : series) % TS_PLOT_COLOURS;
}

size_t ts_plot_marker_of(size_t series)
{
	return series % TS_PLOT_MARKERS;
}

bool ts_plot_has_line(const struct ts_plot_series *s)
{
	return s->style != TS_PLOT_POINTS;
}

bool ts_plot_has_points(const struct ts_plot_series *s)
{
	if (s->style == TS_PLOT_AUTO)
		return s->n <= FEW || s->error || s->x_error;
	return s->style == TS_PLOT_POINTS || s->style == TS_PLOT_BOTH;
}

const struct ts_plot_axis *ts_plot_axis_of(const struct ts_plot *plot, const struct ts_plot_series *s)
{
	return s->right ? &plot->right : &plot->y;
}

bool ts_plot_has_right(const struct ts_plot *plot)
{
	for (size_t k = 0; k < plot->n; k++)
		if (plot->series[k].right)
			return true;
	return false;
}

double ts_plot_x(const struct ts_plot_series *s, size_t k)
{
	return s->x ? s->x[k] : (double)k;
}

bool ts_plot_shows(const struct ts_plot_axis *axis, double value)
{
	return fabs(value) <= LARGEST && (!axis->log || value >= LEAST);
}
