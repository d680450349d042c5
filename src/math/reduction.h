/* One number out of many: sums are rounded once, so no outcome depends on the order. */
#ifndef TS_MATH_REDUCTION_H
#define TS_MATH_REDUCTION_H

#include <math.h>

#include "math/exactsum.h"

#define TS_TALLY_LIST(X)                                                                           \
	X(SUM, "sum")                                                                              \
	X(MIN, "min")                                                                              \
	X(MAX, "max")                                                                              \
	X(AVE, "ave")                                                                              \
	X(SUMSQ, "sumsq")                                                                          \
	X(AVESQ, "avesq")                                                                          \
	X(SUMABS, "sumabs")                                                                        \
	X(AVEABS, "aveabs")                                                                        \
	X(MINABS, "minabs")                                                                        \
	X(MAXABS, "maxabs")
#define TS_TALLY_ENUM(name, text) TS_TALLY_##name,
enum ts_tally_mode { TS_TALLY_LIST(TS_TALLY_ENUM) TS_NTALLY };
#undef TS_TALLY_ENUM
extern const char *const ts_tally_names[]; /* for argument rows, closed by NULL */

struct ts_tally {
	struct ts_exactsum sum;
	double least, most;
	size_t n;
};

static inline struct ts_tally ts_tally_start(void)
{
	return (struct ts_tally){ ts_exactsum_start(), INFINITY, -INFINITY, 0 };
}

void ts_tally_add(struct ts_tally *tally, enum ts_tally_mode mode, double value);
/* Of no values: 0. */
double ts_tally_value(const struct ts_tally *tally, enum ts_tally_mode mode);

#endif
