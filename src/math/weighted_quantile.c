#include "math/weighted_quantile.h"

#include <math.h>

#include "base/sort.h"
#include "math/compensated.h"

#include "base/banned.h"

static int compare(const void *a, const void *b)
{
	const struct ts_weighted *x = a, *y = b;

	if (x->value != y->value)
		return x->value < y->value ? -1 : 1;
	return (x->weight > y->weight) - (x->weight < y->weight);
}

void ts_weighted_sort(struct ts_weighted *number, size_t n)
{
	ts_sort(number, n, sizeof *number, compare);
}

double ts_weighted_quantile(const struct ts_weighted *number, size_t n, double q)
{
	struct ts_compensated_sum whole = { 0 }, below = { 0 };
	double part, rounding;

	for (size_t k = 0; k < n; k++)
		ts_compensated_add(&whole, number[k].weight);
	part = q * ts_compensated_value(&whole);
	rounding = 1e-14 * ts_compensated_value(&whole);
	for (size_t k = 0; k < n; k++) {
		double rest;

		ts_compensated_add(&below, number[k].weight);
		rest = ts_compensated_value(&below) - part;
		if (rest > rounding || k + 1 == n)
			return number[k].value;
		if (fabs(rest) <= rounding)
			return 0.5 * number[k].value + 0.5 * number[k + 1].value;
	}
	return 0;
}
