#include "math/reduction.h"

#include "base/banned.h"

#define NAME(name, text) text,
const char *const ts_tally_names[] = { TS_TALLY_LIST(NAME) NULL };
#undef NAME

void ts_tally_add(struct ts_tally *tally, enum ts_tally_mode mode, double value)
{
	if (mode == TS_TALLY_SUMSQ || mode == TS_TALLY_AVESQ)
		value *= value;
	if (mode >= TS_TALLY_SUMABS)
		value = fabs(value);
	ts_exactsum_add(&tally->sum, value);
	tally->least = fmin(tally->least, value);
	tally->most = fmax(tally->most, value);
	tally->n++;
}

double ts_tally_value(const struct ts_tally *tally, enum ts_tally_mode mode)
{
	if (tally->n == 0)
		return 0;
	switch (mode) {
	case TS_TALLY_MIN:
	case TS_TALLY_MINABS:
		return tally->least;
	case TS_TALLY_MAX:
	case TS_TALLY_MAXABS:
		return tally->most;
	case TS_TALLY_AVE:
	case TS_TALLY_AVESQ:
	case TS_TALLY_AVEABS:
		return ts_exactsum_value(&tally->sum) / (double)tally->n;
	default:
		return ts_exactsum_value(&tally->sum);
	}
}
