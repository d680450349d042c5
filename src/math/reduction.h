/* Reductions of many numbers to one; sums are exact, so results do not depend on the order. */
#ifndef TS_MATH_REDUCTION_H
#define TS_MATH_REDUCTION_H

#include <math.h>

#include "math/exactsum.h"

/* clang-format off */
#define TS_REDUCTION_LIST(X)                                                                           \
	X(SUM, "sum")                                                                              \
	X(MIN, "min")                                                                              \
	X(MAX, "max")                                                                              \
	X(AVE, "ave")                                                                              \
	X(SUMSQ, "sumsq")                                                                          \
	X(AVESQ, "avesq")                                                                          \
	X(SUMABS, "sumabs")                                                                        \
	X(AVEABS, "aveabs")                                                                        \
	X(MINABS, "minabs")                                                                        \
	X(MAXABS, "maxabs")                                                                            \
	X(STD, "std")
/* clang-format on */
#define TS_REDUCTION_ENUM(name, text) TS_REDUCTION_##name,
enum ts_reduction_mode { TS_REDUCTION_LIST(TS_REDUCTION_ENUM) TS_NREDUCTION };
#undef TS_REDUCTION_ENUM
extern const char *const ts_reduction_names[]; /* for argument tables, NULL-terminated */

struct ts_reduction {
	struct ts_exactsum sum, squares; /* squares: of STD only */
	struct ts_exactsum large;	 /* squares of values whose squares could overflow, scaled */
	double min, max;
	size_t n, nlarge;
};

static inline struct ts_reduction ts_reduction_start(void)
{
	return (struct ts_reduction){ .min = INFINITY, .max = -INFINITY };
}

void ts_reduction_add(struct ts_reduction *tally, enum ts_reduction_mode mode, double value);
/* Result; 0 without values. STD is the standard deviation of the values, sqrt(<(x - <x>)^2>), without cancellation. */
double ts_reduction_value(const struct ts_reduction *tally, enum ts_reduction_mode mode);

#endif
