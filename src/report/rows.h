/* Rows of numbers over a common coordinate, thinned to a bounded number: once there are too many, neighbours are merged in
 * pairs, of which the least and the greatest number of each column remain. A curve through these shows every peak. */
#ifndef TS_REPORT_ROWS_H
#define TS_REPORT_ROWS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"

enum { TS_ROWS_MOST = 256 };

/* Numbers of a column over all rows; those that are not finite are only counted. */
struct ts_rows_sum {
	double first, last, least, greatest;
	int64_t finite, odd;
};

struct ts_rows_span; /* least and greatest number of a column in merged rows */

struct ts_rows {
	size_t columns;
	int64_t count;		   /* rows added */
	size_t n;		   /* merged rows */
	int64_t each;		   /* rows merged in one, but for the last */
	double x[TS_ROWS_MOST][2]; /* coordinates of the first and last row of each */
	int64_t merged[TS_ROWS_MOST];
	struct ts_rows_span *span; /* [TS_ROWS_MOST][columns] */
	struct ts_rows_sum *sum;   /* [columns] */
};

/* Zero-initialise before the first call. TS_NOMEM: no memory. */
enum ts_status ts_rows_begin(struct ts_rows *rows, size_t columns);
void ts_rows_add(struct ts_rows *rows, double x, const double *values);
/* Points of a column in the order of the rows, at most 2 TS_ROWS_MOST; returns their number. */
size_t ts_rows_curve(const struct ts_rows *rows, size_t column, double *x, double *y);
/* Whether all numbers of a column are the same. */
bool ts_rows_is_constant(const struct ts_rows *rows, size_t column);
void ts_rows_release(struct ts_rows *rows);

#endif
