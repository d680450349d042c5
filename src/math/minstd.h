/* The minimal standard random number generator of S. K. Park, K. W. Miller, Comm. ACM 31 (1988) 1192: s
 * <- 16807 s mod 2^31 - 1.
 *
 * Used for the random streams of LIGGGHTS, so that a script gives the same packing. All other random
 * numbers come from math/rng.h. */
#ifndef TS_MATH_MINSTD_H
#define TS_MATH_MINSTD_H

#include <stdbool.h>
#include <stdint.h>

struct ts_minstd {
	int32_t state; /* 1 .. 2^31 - 2 */
	int32_t has_spare;
	double spare; /* normal deviates are generated in pairs */
};

/* 0 < seed < 2^31 - 1 */
static inline struct ts_minstd ts_minstd_start(int64_t seed)
{
	return (struct ts_minstd){ .state = (int32_t)seed };
}

/* Uniform in (0, 1). */
static inline double ts_minstd_uniform(struct ts_minstd *r)
{
	r->state = (int32_t)((int64_t)r->state * 16807 % 2147483647);
	return (1.0 / 2147483647) * r->state;
}

/* Normal with mean 0 and standard deviation 1 (Marsaglia's polar method). */
double ts_minstd_normal(struct ts_minstd *r);

/* LIGGGHTS accepts only primes as seeds. */
bool ts_minstd_is_prime(int64_t n);

#endif
