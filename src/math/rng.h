/* Counter-based random numbers: Philox4x32-10 of J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw,
 * "Parallel random numbers: as easy as 1, 2, 3", SC11 (2011).
 *
 * The k-th number of (seed, stream) is a pure function of these three, so the numbers of a particle
 * depend on its identity, not on the order of particles or the number of threads. */
#ifndef TS_MATH_RNG_H
#define TS_MATH_RNG_H

#include <stddef.h>
#include <stdint.h>

struct ts_rng {
	uint64_t seed, stream; /* streams of one seed are independent: one per purpose or particle */
	uint64_t counter;      /* number of draws so far */
};

static inline struct ts_rng ts_rng_start(uint64_t seed, uint64_t stream)
{
	return (struct ts_rng){ seed, stream, 0 };
}

/* Uniform in the open interval (0, 1); 52 random bits. */
double ts_rng_uniform(struct ts_rng *rng);
/* The number with this counter of each of n streams of a seed, as ts_rng_uniform draws it. */
void ts_rng_uniform_of_streams(uint64_t seed, uint64_t counter, const int32_t stream[], size_t n,
			       double out[]);
/* Normal with mean 0 and standard deviation 1. */
double ts_rng_normal(struct ts_rng *rng);

/* The Philox bijection: encrypts a counter of four words with a key of two. */
void ts_rng_philox(const uint32_t counter[4], const uint32_t key[2], uint32_t out[4]);

#endif
