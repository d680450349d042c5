/* A list of all columns of a file, for the terminal. */
#ifndef TS_VIEW_VIEW_OVERVIEW_H
#define TS_VIEW_VIEW_OVERVIEW_H

#include "view/view_data.h"

/* Appends a line for each column: its range, its mean, and its course as small bars if the terminal has them. */
enum ts_status ts_view_overview(struct ts_view_data *v, const struct ts_view_file *f, struct ts_str *out);

#endif
