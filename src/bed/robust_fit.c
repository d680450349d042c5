#include "bed/robust_fit.h"

#include <math.h>

#include "base/alloc.h"
#include "base/sort.h"
#include "math/symmetric3.h"

#include "base/banned.h"

/* Components of symmetric matrices in the order of math/symmetric3.h. */
static const int row_of[6] = { 0, 1, 2, 0, 0, 1 }, column_of[6] = { 0, 1, 2, 1, 2, 2 };

double ts_robust_value(const struct ts_robust_fit *fit, const struct ts_robust_point *point)
{
	double y = 0;

	for (int k = 0; k < TS_ROBUST_TERMS; k++)
		y += fit->coefficient[k] * point->term[k];
	return y;
}

/* Weighted normal equations; unused coefficients have the equation 1 * c = 0. */
static bool solve(const struct ts_robust_point *point, const double *weight, size_t n, int terms,
		  struct ts_robust_fit *fit)
{
	double a[6] = { 0 }, b[3] = { 0 }, value[3], v[3][3], lowest = INFINITY, sum = 0, squares = 0, free;

	fit->points = 0;
	for (size_t i = 0; i < n; i++) {
		double w = weight[i];

		for (int k = 0; k < 6; k++)
			a[k] += w * point[i].term[row_of[k]] * point[i].term[column_of[k]];
		for (int k = 0; k < 3; k++)
			b[k] += w * point[i].term[k] * point[i].y;
		fit->points += w > 0;
		sum += w;
	}
	fit->defined = fit->points > (size_t)terms;
	if (!fit->defined)
		return false;
	for (int k = 0; k < 6; k++)
		a[k] /= sum;
	for (int k = 0; k < 3; k++)
		b[k] /= sum;
	for (int k = terms; k < 3; k++)
		a[k] = 1;
	ts_symmetric3_eigen(a, value, v);
	for (int k = 0; k < 3; k++)
		lowest = fmin(lowest, value[k]);
	fit->defined = lowest > 1e-10;
	if (!fit->defined)
		return false;
	ts_symmetric3_solve(a, b, fit->coefficient);
	for (size_t i = 0; i < n; i++) {
		double d = point[i].y - ts_robust_value(fit, &point[i]);

		squares += weight[i] * d * d;
	}
	fit->rms = sqrt(squares / sum);
	free = (double)fit->points - terms;
	for (int k = 0; k < terms; k++) {
		double unit[3] = { k == 0, k == 1, k == 2 }, x[3];

		ts_symmetric3_solve(a, unit, x);
		fit->error[k] = fit->rms * sqrt(fmax(x[k], 0) / free);
	}
	return true;
}

/* Weights from the residuals; `spare`: room for n numbers. */
static void reweight(const struct ts_robust_point *point, size_t n, const struct ts_robust_fit *fit,
		     double *weight, double *spare)
{
	double limit;
	size_t m = 0;

	for (size_t i = 0; i < n; i++)
		if (point[i].selected)
			spare[m++] = fabs(point[i].y - ts_robust_value(fit, &point[i]));
	ts_sort(spare, m, sizeof *spare, ts_compare_double);
	/* a floor far above rounding, for points exactly on the line; terms are of order 1 */
	limit = 4.685 * fmax(1.4826 * spare[m / 2], 1e-7);
	for (size_t i = 0; i < n; i++) {
		double u = (point[i].y - ts_robust_value(fit, &point[i])) / limit;

		weight[i] = point[i].selected && fabs(u) < 1 ? (1 - u * u) * (1 - u * u) : 0;
	}
}

static void iterate(const struct ts_robust_point *point, size_t n, int terms, double *weight, double *spare,
		    struct ts_robust_fit *out)
{
	enum { ROUNDS = 50 };

	for (size_t i = 0; i < n; i++)
		weight[i] = point[i].selected;
	for (int round = 0; solve(point, weight, n, terms, out) && round < ROUNDS; round++)
		reweight(point, n, out, weight, spare);
}

enum ts_status ts_robust_fit(const struct ts_robust_point *point, size_t n, int terms,
			     struct ts_robust_fit *out)
{
	double *weight = ts_alloc(2 * n, sizeof *weight);

	*out = (struct ts_robust_fit){ 0 };
	if (!weight)
		return TS_NOMEM;
	iterate(point, n, terms, weight, weight + n, out);
	ts_free(weight);
	return TS_OK;
}
