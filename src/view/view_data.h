/* The tables of a -plot and what is drawn of them. */
#ifndef TS_VIEW_VIEW_DATA_H
#define TS_VIEW_VIEW_DATA_H

#include "sheet/sheet.h"
#include "view/view.h"

/* A column to be drawn. */
struct ts_view_column {
	size_t column, error; /* error: SIZE_MAX: none */
	const char *label;    /* NULL: its name */
	bool right;	      /* by the axis on the right */
};

/* A file. Its parts that are drawn have the same columns. */
struct ts_view_file {
	const struct ts_view_source *source;
	struct ts_sheets sheets;
	const struct ts_sheet **part; /* [parts] */
	size_t parts, left_out;	      /* left_out: parts with other columns */
	bool joined;		      /* all parts are one curve */
	size_t x;		      /* column; SIZE_MAX: the number of the row */
	size_t x_error;		      /* SIZE_MAX: none */
	struct ts_view_column *y;     /* [ny] */
	size_t ny;
	enum ts_plot_style style;
	size_t *by, nby;	      /* columns that tell curves apart */
	size_t first_result, results; /* columns of results of a study; 0, 0: it is none */
};

struct ts_view_curve {
	const char *name;   /* what tells it from other curves of the column; "": nothing */
	const char *column; /* its label */
	struct ts_plot_series series;
	double *x, *y, *error, *x_error;
	size_t capacity[4];
};

struct ts_view_data {
	struct tsim *sim;
	const struct ts_view_input *in;
	struct ts_arena arena;
	struct ts_view_file *file; /* [n of in] */
	struct ts_view_curve *curve;
	size_t curves, capacity;
};

/* Reads the files, chooses parts and columns. */
enum ts_status ts_view_data_read(struct ts_view_data *v);
/* Makes the curves of a column of a file. */
enum ts_status ts_view_data_curves(struct ts_view_data *v, const struct ts_view_file *f,
				   const struct ts_view_column *column);
/* Removes all curves. */
void ts_view_data_forget(struct ts_view_data *v);
void ts_view_data_release(struct ts_view_data *v);

/* Columns that are x, a variable, an error or a number of runs are not drawn unless they are named. */
bool ts_view_is_drawn(const struct ts_view_file *f, size_t column);

#endif
