/* A series as it is drawn: vertices in units of the plot, inside the frame, and no more of them than are seen.
 *
 * Of successive points in a column of half a unit, a third of the width of a line, the first, the lowest, the highest
 * and the last are kept (Jugel, Jerzak, Hackenbroich and Markl 2014, M4: A visualization-oriented time series data
 * aggregation, Proc. VLDB Endowment 7, 797): the curve covers the same pixels and no extreme is lost. Of points without
 * lines one is kept in each square of that size. A line that goes forth and back, with more than 20 000 vertices, is
 * drawn on only where it reaches squares without a line. */
#ifndef TS_PLOT_PLOT_TRACE_H
#define TS_PLOT_PLOT_TRACE_H

#include "plot/plot_layout.h"

struct ts_plot_vertex {
	double x, y;
	size_t point; /* index in the series */
	bool begins;  /* no line leads to it */
};

/* Zero-initialise. */
struct ts_plot_trace {
	struct ts_plot_vertex *vertex;
	size_t n, capacity;
};

/* Replace the vertices. Return TS_OK or TS_NOMEM. */
enum ts_status ts_plot_trace_line(struct ts_plot_trace *t, const struct ts_plot_layout *l,
				  const struct ts_plot_series *s);
/* Points with markers: all, or of a line without markers those that have no neighbour to be joined with. */
enum ts_status ts_plot_trace_points(struct ts_plot_trace *t, const struct ts_plot_layout *l,
				    const struct ts_plot_series *s);
/* Points with error bars. */
enum ts_status ts_plot_trace_errors(struct ts_plot_trace *t, const struct ts_plot_layout *l,
				    const struct ts_plot_series *s);
void ts_plot_trace_release(struct ts_plot_trace *t);

/* Ends of the error bars at a point, of y and of x, clipped to the frame; false: none. */
bool ts_plot_error_bar(const struct ts_plot_layout *l, const struct ts_plot_series *s, size_t point,
		       double *top, double *bottom);
bool ts_plot_error_bar_x(const struct ts_plot_layout *l, const struct ts_plot_series *s, size_t point,
			 double *left, double *right);

#endif
