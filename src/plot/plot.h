/* The description of a plot: curves y(x) in one frame. It is drawn by plot_svg.h, plot_raster.h and plot_terminal.h.
 *
 *   const struct ts_plot_series s = { .name = "measured", .x = t, .y = v, .n = n };
 *   const struct ts_plot p = { .title = "Fall", .x = { "time", "s" }, .y = { "speed", "m/s" }, .series = &s, .n = 1 };
 *   ts_plot_svg(&p, stdout);
 *
 * All texts are UTF-8; they and the numbers belong to the caller. A number that is not finite is no point and
 * interrupts the curve; so does one that is not positive on a logarithmic axis. The plot says how many of them it does
 * not show. */
#ifndef TS_PLOT_PLOT_H
#define TS_PLOT_PLOT_H

#include <stdbool.h>
#include <stddef.h>

enum ts_plot_style {
	TS_PLOT_AUTO, /* lines, and points if there are few or if they have errors */
	TS_PLOT_LINES,
	TS_PLOT_POINTS,
	TS_PLOT_BOTH,
	TS_PLOT_STEPS /* each value from half way to the point before to half way to the next: histograms */
};

struct ts_plot_axis {
	const char *label, *unit; /* NULL: none */
	bool log;
	/* Ends, lo < hi. NaN: from the data, as are both if lo == hi. On a logarithmic axis ends that are not positive
	 * come from the data, too. */
	double lo, hi;
};

struct ts_plot_series {
	const char *name;      /* in the legend; NULL: none */
	const double *x;       /* [n]; NULL: 0, 1, 2 ... */
	const double *y;       /* [n] */
	const double *error;   /* [n], of y, to both sides; NULL: none. NaN or 0: none at this point */
	const double *x_error; /* the same of x */
	size_t n;
	enum ts_plot_style style;
	int colour; /* 1, 2 ...: of the palette; 0: by the place among the series */
	bool right; /* y belongs to the axis on the right */
};

/* A line across the frame, dashed. */
struct ts_plot_mark {
	const char *name; /* written at the line; NULL: none */
	double at;
	bool vertical; /* at x = at; otherwise y = at */
};

/* Zero-initialise. */
struct ts_plot {
	const char *title; /* NULL: none */
	struct ts_plot_axis x, y;
	struct ts_plot_axis right; /* the second one of y; drawn if a series belongs to it */
	const struct ts_plot_series *series;
	size_t n;
	const struct ts_plot_mark *mark;
	size_t marks;
	/* Size in units; letters are 13 units high. 0: 480 and 320; less than 160: 160. A long legend makes
	 * the plot higher. */
	int width, height;
};

/* Number of colours: those of Okabe and Ito (2008), Color Universal Design, without yellow, which is not seen on white, and
 * moved apart: with a contrast to the ground of at least 3, all pairs differ by at least 22 of CIELAB for the three kinds of
 * colour blindness as well (model of Machado, Oliveira and Fernandes, IEEE Trans. Vis. Comput. Graph. 15 (2009) 1291); the
 * originals differ by 16. The last is that of the letters. Series beyond repeat them; markers differ, too. */
enum { TS_PLOT_COLOURS = 7, TS_PLOT_MARKERS = 4 };
/* With more points than these their markers are small dots. */
enum { TS_PLOT_CROWD = 1000 };
/* 0xRRGGBB of colour k = 0, 1 ... on a white or on a dark ground. */
unsigned ts_plot_colour(size_t k, bool dark);
/* Colour and marker of a series, from 0. */
size_t ts_plot_colour_of(const struct ts_plot *plot, size_t series);
size_t ts_plot_marker_of(size_t series);
/* Whether lines and points are drawn. */
bool ts_plot_has_line(const struct ts_plot_series *s);
bool ts_plot_has_points(const struct ts_plot_series *s);
/* The axis of its y. */
const struct ts_plot_axis *ts_plot_axis_of(const struct ts_plot *plot, const struct ts_plot_series *s);
bool ts_plot_has_right(const struct ts_plot *plot);
/* Coordinates of point k. */
double ts_plot_x(const struct ts_plot_series *s, size_t k);
/* Whether the axis can show the number. */
bool ts_plot_shows(const struct ts_plot_axis *axis, double value);

#endif
