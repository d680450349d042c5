/* `tsim -plot`: columns of tables in files as curves, on the terminal or as a picture. */
#ifndef TS_VIEW_VIEW_H
#define TS_VIEW_VIEW_H

#include "core/sim.h"
#include "plot/plot_terminal.h"

/* Words of the command line; NULL: not given. */
struct ts_view_source {
	const char *path;
	/* NAME[+-ERROR][=LABEL], by name or number; none: those of the source before, else all */
	struct ts_words columns;
	struct ts_words right; /* columns by the axis on the right */
	const char *x;	       /* column of the horizontal axis, [+-ERROR] */
	const char *style;     /* lines, points, both, steps */
};

struct ts_view_input {
	const struct ts_view_source *source;
	size_t n;	   /* >= 1 */
	const char *out;   /* .svg or .png; NULL: terminal */
	const char *log;   /* some of x, y and r, the right axis */
	const char *by;	   /* columns, separated by commas: a curve for each set of their values */
	const char *part;  /* number of the run or block; last, all */
	const char *style; /* lines, points, both, steps */
	const char *title; /* "": none */
	const char *xlabel, *ylabel, *right_label;
	bool panels;				   /* a plot for each column, also if they are named */
	const char *size;			   /* WIDTHxHEIGHT of a plot in units of plot.h */
	const char *xrange, *yrange, *right_range; /* LO:HI, either may be absent */
	struct ts_words marks;			   /* x=VALUE[:NAME], y=VALUE[:NAME] */
	struct ts_plot_terminal terminal;
};

/* Writes the picture, or appends the plot or an overview of all columns to `text`. Returns TS_OK or the status of
 * sim->error. */
enum ts_status ts_view(struct tsim *sim, const struct ts_view_input *in, struct ts_str *text);

/* Appends the help on the words, for tsim -help. */
void ts_view_help(struct ts_str *out);

#endif
