/* Straight line through points, by least squares. */
#ifndef TS_MATH_FIT_H
#define TS_MATH_FIT_H

#include <stddef.h>

#include "base/status.h"

struct ts_fit {
	double intercept, slope;
	double slope_error; /* standard error of the slope; 0 for two points */
	double residual;    /* sum of squares of y - (intercept + slope x) */
	size_t n;
};

/* y = intercept + slope x. x NULL: 0, 1, 2 ... n-1. TS_RANGE if there are fewer than two points, a
 * value is not finite, or all x are equal. */
enum ts_status ts_fit_line(const double *x, const double *y, size_t n, struct ts_fit *out);

#endif
