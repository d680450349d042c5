/* Plots of letters, for a terminal. */
#ifndef TS_PLOT_PLOT_TERMINAL_H
#define TS_PLOT_PLOT_TERMINAL_H

#include "base/str.h"
#include "plot/plot.h"

struct ts_plot_terminal {
	int columns, rows; /* size of the whole without the legend; at least 24 and 8 are taken */
	bool unicode;	   /* curves of braille dots, two by four in a letter; otherwise ASCII only */
	bool colour;	   /* escape sequences for the colours of the series */
};

/* Appends the lines. Without colours several series are told apart by letters instead of dots. Returns TS_OK or
 * TS_NOMEM. */
enum ts_status ts_plot_terminal(const struct ts_plot *plot, const struct ts_plot_terminal *terminal,
				struct ts_str *out);

#endif
