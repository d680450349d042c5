#include "math/reduction.h"

#include "base/banned.h"

#define NAME(name, text) text,
const char *const ts_reduction_names[] = { TS_REDUCTION_LIST(NAME) NULL };
#undef NAME

/* Adds a b: the rounded product and its rounding error, which together are exact. */
static void add_product(struct ts_exactsum *sum, double a, double b)
{
	double product = a * b;

	ts_exactsum_add(sum, product);
	if (isfinite(product))
		ts_exactsum_add(sum, fma(a, b, -product));
}

/* Beyond this size squares overflow in a sum; then all is scaled by a power of two, which is exact. */
static const double most = 0x1p500, shrink = 0x1p-600;

static void add_square(struct ts_reduction *tally, double value)
{
	if (fabs(value) < most) {
		add_product(&tally->squares, value, value);
	} else {
		add_product(&tally->large, value * shrink, value * shrink);
		tally->nlarge++;
	}
}

/* n times the variance is sum x^2 - 2 m sum x + n m^2 with the rounded mean m: all terms are added exactly, so that
 * nothing cancels even where the mean is large beside the deviation. */
static double deviation(const struct ts_reduction *tally)
{
	double scale = tally->nlarge ? shrink : 1;
	struct ts_exactsum square = tally->nlarge ? tally->large : tally->squares, rest = tally->sum;
	double n = (double)tally->n, value = ts_exactsum_value(&tally->sum), sum = scale * value;
	double mean = sum / n, variance;

	if (tally->nlarge)
		ts_exactsum_add(&square, ts_exactsum_value(&tally->squares) * scale * scale);
	ts_exactsum_add(&rest, -value);
	add_product(&square, -2 * mean, sum);
	add_product(&square, -2 * mean, scale * ts_exactsum_value(&rest));
	add_product(&square, n, mean * mean);
	add_product(&square, n, fma(mean, mean, -(mean * mean)));
	variance = ts_exactsum_value(&square) / n;
	return variance < 0 ? 0 : sqrt(variance) / scale;
}

void ts_reduction_add(struct ts_reduction *tally, enum ts_reduction_mode mode, double value)
{
	if (mode == TS_REDUCTION_SUMSQ || mode == TS_REDUCTION_AVESQ)
		value *= value;
	if (mode == TS_REDUCTION_STD)
		add_square(tally, value);
	if (mode >= TS_REDUCTION_SUMABS && mode <= TS_REDUCTION_MAXABS)
		value = fabs(value);
	ts_exactsum_add(&tally->sum, value);
	tally->min = value < tally->min ? value : tally->min; /* NaN does not count */
	tally->max = value > tally->max ? value : tally->max;
	tally->n++;
}

double ts_reduction_value(const struct ts_reduction *tally, enum ts_reduction_mode mode)
{
	if (tally->n == 0)
		return 0;
	switch (mode) {
	case TS_REDUCTION_MIN:
	case TS_REDUCTION_MINABS:
		return tally->min;
	case TS_REDUCTION_MAX:
	case TS_REDUCTION_MAXABS:
		return tally->max;
	case TS_REDUCTION_AVE:
	case TS_REDUCTION_AVESQ:
	case TS_REDUCTION_AVEABS:
		return ts_exactsum_value(&tally->sum) / (double)tally->n;
	case TS_REDUCTION_STD:
		return deviation(tally);
	default:
		return ts_exactsum_value(&tally->sum);
	}
}
