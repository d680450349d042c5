/* Exact sums of doubles: the result does not depend on the order of the terms, hence not on threads.
 * The sum is a fixed-point number over the whole range of doubles, stored as limbs of 32 bits in 64-bit
 * words, so that carries can be delayed (U. Kulisch; R. M. Neal, arXiv:1505.05571). Terms wait until there are enough of them
 * to be added together in vectors (S. M. Rump, T. Ogita, S. Oishi, SIAM J. Sci. Comput. 31 (2008) 189). */
#ifndef TS_MATH_EXACTSUM_H
#define TS_MATH_EXACTSUM_H

#include <stddef.h>
#include <stdint.h>

/* 2098 bits from 2^-1074 to 2^1023, and 64 for the growth of the sum. */
enum { TS_EXACTSUM_LIMBS = 68, TS_EXACTSUM_WAITING = 128 };

struct ts_exactsum {
	int64_t limb[TS_EXACTSUM_LIMBS];  /* sum of limb[k] 2^(32 k - 1074) */
	uint32_t carries;		  /* additions since the last carry */
	uint32_t waiting;		  /* terms that the limbs do not have yet */
	double special;			  /* sum of the infinities and NaNs */
	double term[TS_EXACTSUM_WAITING]; /* the terms that wait */
};

static inline struct ts_exactsum ts_exactsum_start(void)
{
	return (struct ts_exactsum){ { 0 }, 0, 0, 0, { 0 } };
}

/* Adds the terms that wait to the limbs: for ts_exactsum_add. */
void ts_exactsum_absorb(struct ts_exactsum *sum);

static inline void ts_exactsum_add(struct ts_exactsum *sum, double term)
{
	sum->term[sum->waiting++] = term;
	if (sum->waiting == TS_EXACTSUM_WAITING)
		ts_exactsum_absorb(sum);
}

/* Adds a term to each of n sums, which have had the same number of terms before. */
static inline void ts_exactsum_add_each(struct ts_exactsum sum[], size_t n, const double term[])
{
	const uint32_t at = sum[0].waiting;

	for (size_t k = 0; k < n; k++) {
		sum[k].term[at] = term[k];
		sum[k].waiting = at + 1;
	}
	for (size_t k = 0; at + 1 == TS_EXACTSUM_WAITING && k < n; k++)
		ts_exactsum_absorb(&sum[k]);
}

/* Adds n terms; what is in term[] afterwards is not defined. */
void ts_exactsum_add_block(struct ts_exactsum *sum, double term[TS_EXACTSUM_WAITING], size_t n);

/* Adds another sum. */
void ts_exactsum_merge(struct ts_exactsum *sum, const struct ts_exactsum *other);
/* Writes the sum as integers, or reads it: the sum of such integers of at most 2^31 sums, number by number, is that of their
 * sums. */
enum { TS_EXACTSUM_INTEGERS = TS_EXACTSUM_LIMBS + 3 };
void ts_exactsum_pack(struct ts_exactsum *sum, int64_t integer[TS_EXACTSUM_INTEGERS]);
struct ts_exactsum ts_exactsum_unpack(const int64_t integer[TS_EXACTSUM_INTEGERS]);
/* The exact sum, rounded once to nearest-even. */
double ts_exactsum_value(const struct ts_exactsum *sum);

/* Exact sum of n numbers that are `stride` apart. */
double ts_exactsum_of(const double *data, size_t n, size_t stride);

#endif
