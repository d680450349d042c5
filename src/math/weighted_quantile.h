/* Quantiles of weighted numbers: d10, d50, d90 of sizes by number, mass or volume. */
#ifndef TS_MATH_WEIGHTED_QUANTILE_H
#define TS_MATH_WEIGHTED_QUANTILE_H

#include <stddef.h>

struct ts_weighted {
	double value, weight; /* weight > 0 */
};

/* Sorts by value, then by weight: sums over the sorted numbers do not depend on their first order. */
void ts_weighted_sort(struct ts_weighted *number, size_t n);

/* The quantile q, 0 to 1, of n sorted numbers: the smallest one up to which they weigh more than q of the whole; where
 * those up to one weigh exactly q, to within rounding, the mean of this and the next one, as in the median of an even
 * number (definition 2 of R. J. Hyndman, Y. Fan, Am. Stat. 50 (1996) 361). q = 0 is the least and 1 the greatest
 * number. 0 without numbers. */
double ts_weighted_quantile(const struct ts_weighted *number, size_t n, double q);

#endif
