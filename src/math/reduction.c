#include "math/reduction.h"

#include "base/banned.h"

#define NAME(name, text) text,
const char *const ts_reduction_names[] = { TS_REDUCTION_LIST(NAME) NULL };
#undef NAME

void ts_reduction_add(struct ts_reduction *tally, enum ts_reduction_mode mode, double value)
{
	if (mode == TS_REDUCTION_SUMSQ || mode == TS_REDUCTION_AVESQ)
		value *= value;
	if (mode >= TS_REDUCTION_SUMABS)
		value = fabs(value);
	ts_exactsum_add(&tally->sum, value);
	tally->min = fmin(tally->min, value);
	tally->max = fmax(tally->max, value);
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
	default:
		return ts_exactsum_value(&tally->sum);
	}
}
