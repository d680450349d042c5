/* Random numbers of the automaton: a stream is a function of the seed, the step, the block of cells and the purpose.
 *
 * Philox (math/rng.h) makes the key and the odd increment of a stream; its k-th number is the output function of
 * SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014) of key + k increment: three times as fast as Philox for
 * each number. */
#ifndef TS_AUTOMATON_DRAWS_H
#define TS_AUTOMATON_DRAWS_H

#include <stdint.h>

#include "base/inline.h"
#include "math/rng.h"

enum ts_draws_purpose { TS_DRAWS_ORDER, TS_DRAWS_LAWS, TS_DRAWS_BLOCKS, TS_DRAWS_PLACES };

struct ts_draws_stream {
	uint64_t at, increment;
};

static inline struct ts_draws_stream ts_draws_start(uint64_t seed, int64_t step, uint32_t block,
						    enum ts_draws_purpose purpose)
{
	const uint32_t counter[4] = { (uint32_t)step, (uint32_t)((uint64_t)step >> 32), block,
				      (uint32_t)purpose };
	const uint32_t key[2] = { (uint32_t)seed, (uint32_t)(seed >> 32) };
	uint32_t word[4];

	ts_rng_philox(counter, key, word);
	return (struct ts_draws_stream){ (uint64_t)word[1] << 32 | word[0],
					 ((uint64_t)word[3] << 32 | word[2]) | 1 };
}

TS_INLINE uint64_t ts_draws_mix(uint64_t z)
{
	z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
	z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
	return z ^ z >> 31;
}

static inline uint64_t ts_draws_next(struct ts_draws_stream *s)
{
	return ts_draws_mix(s->at += s->increment);
}

/* Uniform in 0 .. n-1: the upper word of bits n, in 96 bits; the bias is below n/2^64. */
TS_INLINE uint32_t ts_draws_below(uint64_t bits, uint32_t n)
{
	return (uint32_t)(((bits >> 32) * n + ((bits & 0xffffffffu) * n >> 32)) >> 32);
}

#endif
