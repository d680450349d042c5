/* Draws a plot onto a canvas: paths, markers and texts in units of the plot, whatever they become. */
#ifndef TS_PLOT_PLOT_CANVAS_H
#define TS_PLOT_PLOT_CANVAS_H

#include "plot/plot_trace.h"

enum ts_plot_pen {
	TS_PLOT_MINOR,
	TS_PLOT_GRID,
	TS_PLOT_FRAME,
	TS_PLOT_CURVE,
	TS_PLOT_THIN, /* a curve that would fill its frame */
	TS_PLOT_BAR,
	TS_PLOT_DASHED
};
enum ts_plot_align { TS_PLOT_START, TS_PLOT_MIDDLE, TS_PLOT_END };
enum ts_plot_letter { TS_PLOT_NORMAL, TS_PLOT_BOLD, TS_PLOT_SMALL };
/* Instead of the number of a colour: that of the letters. */
enum { TS_PLOT_INK = TS_PLOT_COLOURS };
/* Instead of the number of a marker: the dots of many points. */
enum { TS_PLOT_FINE = TS_PLOT_MARKERS };

/* The first member of a canvas. */
struct ts_plot_canvas {
	/* A path: begin, then `move` and `line` any number of times, end. */
	void (*begin)(struct ts_plot_canvas *self, enum ts_plot_pen pen, size_t colour);
	void (*move)(struct ts_plot_canvas *self, double x, double y);
	void (*line)(struct ts_plot_canvas *self, double x, double y);
	void (*end)(struct ts_plot_canvas *self);
	/* n >= 1 */
	void (*markers)(struct ts_plot_canvas *self, const struct ts_plot_vertex *at, size_t n, size_t marker,
			size_t colour);
	/* One line with its base line at y. */
	void (*text)(struct ts_plot_canvas *self, double x, double y, enum ts_plot_align align,
		     enum ts_plot_letter letter, const char *text, size_t bytes);
};

/* Returns TS_OK or TS_NOMEM. */
enum ts_status ts_plot_canvas_draw(struct ts_plot_canvas *c, const struct ts_plot *plot,
				   const struct ts_plot_layout *l);

#endif
