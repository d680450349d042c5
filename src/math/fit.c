#include "math/fit.h"

#include <math.h>
#include <stdbool.h>

#include <gsl/gsl_fit.h>

#include "base/alloc.h"
#include "base/banned.h"

static bool are_points_valid(const double *x, const double *y, size_t n)
{
	bool spread = false;

	for (size_t i = 0; i < n; i++) {
		if (!isfinite(x[i]) || !isfinite(y[i]))
			return false;
		spread |= x[i] < x[0] || x[i] > x[0];
	}
	return spread;
}

enum ts_status ts_fit_line(const double *x, const double *y, size_t n, struct ts_fit *out)
{
	double *count = NULL, c00, c01, c11;
	enum ts_status status = TS_RANGE;

	*out = (struct ts_fit){ .n = n };
	if (n < 2)
		return TS_RANGE;
	if (!x) {
		count = ts_alloc(n, sizeof *count);
		if (!count)
			return TS_NOMEM;
		for (size_t i = 0; i < n; i++)
			count[i] = (double)i;
		x = count;
	}
	if (are_points_valid(x, y, n) && gsl_fit_linear(x, 1, y, 1, n, &out->intercept, &out->slope, &c00,
							&c01, &c11, &out->residual) == 0) {
		/* With two points there is no degree of freedom, and GSL divides 0 by 0. */
		out->slope_error = n > 2 ? sqrt(c11) : 0;
		status = isfinite(out->slope) ? TS_OK : TS_RANGE;
	}
	ts_free(count);
	return status;
}

/* Sum of the products of deviations `lag` apart. */
static double covariance(const double *y, const struct ts_fit *line, size_t lag)
{
	double sum = 0;

	for (size_t k = lag; k < line->n; k++)
		sum += (y[k] - line->intercept - line->slope * (double)k) *
		       (y[k - lag] - line->intercept - line->slope * (double)(k - lag));
	return sum;
}

double ts_fit_correlation(const double *y, const struct ts_fit *line)
{
	const double variance = covariance(y, line, 0);
	double tau = 0.5;

	for (size_t lag = 1; variance > 0 && lag < line->n && (double)lag <= 5 * tau; lag++)
		tau += covariance(y, line, lag) / variance;
	return tau > 0.5 ? sqrt(2 * tau) : 1;
}
