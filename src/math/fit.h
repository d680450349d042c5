/* Linear regression by least squares. */
#ifndef TS_MATH_FIT_H
#define TS_MATH_FIT_H

#include <stddef.h>

#include "base/status.h"

struct ts_fit {
	double intercept, slope;
	double slope_error; /* standard error of the slope if deviations from the line are independent; 0 for two points */
	double residual; /* sum of squares of y - (intercept + slope x) */
	size_t n;
};

/* Fits y = intercept + slope x; x NULL means 0, 1, 2 ... n-1. Returns TS_RANGE for fewer than two
 * points, for values that are not finite, or if all x are equal. */
enum ts_status ts_fit_line(const double *x, const double *y, size_t n, struct ts_fit *out);

/* Factor by which correlated deviations of y[k] from the line, with x = k, enlarge the standard error of its slope, for
 * correlations that are short against the series: sqrt(2 tau), the integrated autocorrelation time tau = 1/2 + sum
 * rho(k) taken up to the first lag of 5 tau (N. Madras, A. D. Sokal, J. Stat. Phys. 50 (1988) 109, app. C). At least 1. */
double ts_fit_correlation(const double *y, const struct ts_fit *line);

#endif
