/* Linear regression by least squares. */
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

/* Fits y = intercept + slope x; x NULL means 0, 1, 2 ... n-1. Returns TS_RANGE for fewer than two
 * points, for values that are not finite, or if all x are equal. */
enum ts_status ts_fit_line(const double *x, const double *y, size_t n, struct ts_fit *out);

#endif
