/* Compensated summation: a running sum over many steps without the growth of rounding errors (A. Neumaier,
 * ZAMM 54 (1974) 39). */
#ifndef TS_MATH_COMPENSATED_H
#define TS_MATH_COMPENSATED_H

#include <math.h>

struct ts_compensated_sum {
	double sum, lost; /* the value is sum + lost; lost: accumulated rounding errors of sum */
	double turnover;  /* sum of the magnitudes of all terms */
};

static inline void ts_compensated_add(struct ts_compensated_sum *s, double term)
{
	double sum = s->sum + term;

	s->lost += fabs(s->sum) >= fabs(term) ? (s->sum - sum) + term : (term - sum) + s->sum;
	s->sum = sum;
	s->turnover += fabs(term);
}

static inline double ts_compensated_value(const struct ts_compensated_sum *s)
{
	return s->sum + s->lost;
}

#endif
