#include "math/band.h"

#include <math.h>

#include "base/banned.h"

static size_t least(size_t a, size_t b)
{
	return a < b ? a : b;
}

/* Divides each row by its largest element, so that pivots of rows can be compared. */
static bool scale_rows(size_t n, size_t low, size_t high, double *a, double *b)
{
	for (size_t i = 0; i < n; i++) {
		size_t from = i > low ? i - low : 0, to = least(n - 1, i + high);
		double most = 0;

		for (size_t j = from; j <= to; j++)
			most = fmax(most, fabs(*ts_band_at(a, low, high, i, j)));
		if (!(most > 0 && isfinite(most)))
			return false;
		for (size_t j = from; j <= to; j++)
			*ts_band_at(a, low, high, i, j) /= most;
		b[i] /= most;
	}
	return true;
}

static void swap(double *a, double *b)
{
	double t = *a;

	*a = *b;
	*b = t;
}

/* Brings the row with the largest element of column k, of those that may have one, to row k. */
static bool choose_pivot(size_t n, size_t low, size_t high, double *a, double *b, size_t k)
{
	size_t best = k, to = least(n - 1, k + low + high);

	for (size_t i = k + 1; i <= least(n - 1, k + low); i++)
		if (fabs(*ts_band_at(a, low, high, i, k)) > fabs(*ts_band_at(a, low, high, best, k)))
			best = i;
	if (!(fabs(*ts_band_at(a, low, high, best, k)) > 0))
		return false;
	for (size_t j = k; best > k && j <= to; j++)
		swap(ts_band_at(a, low, high, k, j), ts_band_at(a, low, high, best, j));
	if (best > k)
		swap(&b[k], &b[best]);
	return true;
}

bool ts_band_solve(size_t n, size_t low, size_t high, double *a, double *b)
{
	if (!scale_rows(n, low, high, a, b))
		return false;
	for (size_t k = 0; k < n; k++) {
		if (!choose_pivot(n, low, high, a, b, k))
			return false;
		for (size_t i = k + 1; i <= least(n - 1, k + low); i++) {
			double factor = *ts_band_at(a, low, high, i, k) / *ts_band_at(a, low, high, k, k);

			for (size_t j = k + 1; j <= least(n - 1, k + low + high); j++)
				*ts_band_at(a, low, high, i, j) -= factor * *ts_band_at(a, low, high, k, j);
			b[i] -= factor * b[k];
		}
	}
	for (size_t k = n; k-- > 0;) {
		for (size_t j = k + 1; j <= least(n - 1, k + low + high); j++)
			b[k] -= *ts_band_at(a, low, high, k, j) * b[j];
		b[k] /= *ts_band_at(a, low, high, k, k);
		if (!isfinite(b[k]))
			return false;
	}
	return true;
}
