/* Functions of a list of numbers, such as the vector of a fix: slope(f_trace). */
#include <math.h>
#include <stdlib.h>

#include "base/sort.h"
#include "math/exactsum.h"
#include "math/fit.h"
#include "formula/expr.h"

#include "base/banned.h"

static enum ts_status eval_length(const double *x, size_t n, double *out)
{
	(void)x;
	*out = (double)n;
	return TS_OK;
}

static enum ts_status eval_sum(const double *x, size_t n, double *out)
{
	*out = ts_exactsum_of(x, n, 1);
	return TS_OK;
}

static enum ts_status eval_ave(const double *x, size_t n, double *out)
{
	*out = ts_exactsum_of(x, n, 1) / (double)n;
	return TS_OK;
}

static enum ts_status eval_min(const double *x, size_t n, double *out)
{
	*out = x[0];
	for (size_t i = 1; i < n; i++)
		*out = fmin(*out, x[i]);
	return TS_OK;
}

static enum ts_status eval_max(const double *x, size_t n, double *out)
{
	*out = x[0];
	for (size_t i = 1; i < n; i++)
		*out = fmax(*out, x[i]);
	return TS_OK;
}

/* Trapezoidal rule with unit spacing. */
static enum ts_status eval_trap(const double *x, size_t n, double *out)
{
	*out = ts_exactsum_of(x, n, 1) - 0.5 * (x[0] + x[n - 1]);
	return TS_OK;
}

static enum ts_status eval_slope(const double *x, size_t n, double *out)
{
	struct ts_fit fit;

	TS_TRY(ts_fit_line(NULL, x, n, &fit));
	*out = fit.slope;
	return TS_OK;
}

static enum ts_status eval_stderr(const double *x, size_t n, double *out)
{
	struct ts_fit fit;

	TS_TRY(ts_fit_line(NULL, x, n, &fit));
	*out = fit.slope_error * ts_fit_correlation(x, &fit);
	return TS_OK;
}

static int descending(const void *a, const void *b)
{
	return ts_compare_double(b, a);
}

static void map_sort(double *x, size_t n)
{
	ts_sort(x, n, sizeof *x, ts_compare_double);
}

static void map_rsort(double *x, size_t n)
{
	ts_sort(x, n, sizeof *x, descending);
}

#define SERIES(name_, f, length_, help_)                                                                     \
	{                                                                                                    \
		.name = (name_), .arguments = "list", .help = (help_), .least = 1, .most = 1, .series = (f), \
		.length = (length_)                                                                          \
	}

const struct ts_expr_function ts_series_functions[] = {
	SERIES("length", eval_length, 0, "how many numbers a list has"),
	SERIES("sum", eval_sum, 0, "sum of all numbers of a list"),
	SERIES("ave", eval_ave, 1, "mean of all numbers of a list"),
	SERIES("min", eval_min, 1, "least number of a list"),
	SERIES("max", eval_max, 1, "greatest number of a list"),
	SERIES("trap", eval_trap, 1, "integral by the trapezoidal rule with unit spacing; 0 of one number"),
	SERIES("slope", eval_slope, 2,
	       "slope of the least-squares straight line, unit spacing; of at least 2 numbers"),
	SERIES("stderr", eval_stderr, 3,
	       "standard error of that slope, of at least 3 numbers; deviations from the line may be "
	       "correlated over a time that is short against the list"),
	{ .name = "sort",
	  .arguments = "list",
	  .help = "the list in ascending order",
	  .least = 1,
	  .most = 1,
	  .map = map_sort },
	{ .name = "rsort",
	  .arguments = "list",
	  .help = "the list in descending order",
	  .least = 1,
	  .most = 1,
	  .map = map_rsort },
	{ .name = NULL },
};
