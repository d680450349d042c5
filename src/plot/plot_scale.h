/* An axis of a plot as it is drawn: its ends, ticks at round numbers, and where a number is. */
#ifndef TS_PLOT_PLOT_SCALE_H
#define TS_PLOT_PLOT_SCALE_H

#include "base/str.h"
#include "plot/plot.h"

enum { TS_PLOT_TICKS = 24, TS_PLOT_TICK_TEXT = 16 };

struct ts_plot_tick {
	double at;		      /* 0: lower end, 1: upper end of the axis */
	char text[TS_PLOT_TICK_TEXT]; /* ASCII: -0.25, 1e-6; "": a minor tick */
};

struct ts_plot_scale {
	bool log;
	double lo, hi; /* ends; of a logarithmic axis their decimal logarithms */
	struct ts_plot_tick tick[TS_PLOT_TICKS + 1];
	size_t n;
	/* The numbers at the ticks are (value - offset) / 10^exponent. An offset is taken off where the range is small
	 * against its distance from zero; it is written with so many digits. */
	double offset;
	int exponent, offset_digits;
};

/* Ranges of the data and number of points without a place. */
struct ts_plot_extent {
	double lo[3], hi[3]; /* x, y and y on the right */
	size_t points, hidden;
};

void ts_plot_extent(const struct ts_plot *plot, struct ts_plot_extent *extent);
/* Scale of x (0), y (1) or y on the right (2) with about so many ticks. */
void ts_plot_scale_set(struct ts_plot_scale *scale, const struct ts_plot *plot,
		       const struct ts_plot_extent *extent, int axis, int ticks);
/* Place of a number that the axis can show: 0 at the lower, 1 at the upper end. Others: NaN. */
double ts_plot_scale_at(const struct ts_plot_scale *scale, double value);
/* Appends "label - offset (10^exponent unit)". */
void ts_plot_scale_title(const struct ts_plot_scale *scale, const struct ts_plot_axis *axis,
			 struct ts_str *out);
/* Appends the text of a tick with typographic signs: 1e-6 as 10 with a raised -6. */
void ts_plot_scale_pretty(const char *text, struct ts_str *out);
/* Appends a power of ten in these signs. */
void ts_plot_scale_power(int exponent, struct ts_str *out);

#endif
