#include "math/rng.h"

#include <math.h>

#include "base/clones.h"
#include "base/inline.h"

#include "base/banned.h"

/* The four words are encrypted in place. */
TS_INLINE void philox(uint32_t *w0, uint32_t *w1, uint32_t *w2, uint32_t *w3, uint32_t k0, uint32_t k1)
{
	uint32_t x0 = *w0, x1 = *w1, x2 = *w2, x3 = *w3;

#pragma GCC unroll 10
	for (int round = 0; round < 10; round++) {
		uint64_t a = UINT64_C(0xd2511f53) * x0, b = UINT64_C(0xcd9e8d57) * x2;

		x0 = (uint32_t)(b >> 32) ^ x1 ^ k0;
		x1 = (uint32_t)b;
		x2 = (uint32_t)(a >> 32) ^ x3 ^ k1;
		x3 = (uint32_t)a;
		k0 += 0x9e3779b9u;
		k1 += 0xbb67ae85u;
	}
	*w0 = x0, *w1 = x1, *w2 = x2, *w3 = x3;
}

void ts_rng_philox(const uint32_t counter[4], const uint32_t key[2], uint32_t out[4])
{
	for (int i = 0; i < 4; i++)
		out[i] = counter[i];
	philox(&out[0], &out[1], &out[2], &out[3], key[0], key[1]);
}

static void draw_words(struct ts_rng *rng, uint64_t out[2])
{
	uint64_t c = rng->counter++;
	const uint32_t counter[4] = { (uint32_t)c, (uint32_t)(c >> 32), (uint32_t)rng->stream,
				      (uint32_t)(rng->stream >> 32) };
	const uint32_t key[2] = { (uint32_t)rng->seed, (uint32_t)(rng->seed >> 32) };
	uint32_t word[4];

	ts_rng_philox(counter, key, word);
	out[0] = (uint64_t)word[1] << 32 | word[0];
	out[1] = (uint64_t)word[3] << 32 | word[2];
}

/* 52 bits plus one half: never 0 or 1. */
TS_INLINE double to_open_unit_interval(uint64_t bits)
{
	/* 2^52 plus the whole number, whose conversion few instruction sets have */
	const union {
		uint64_t bits;
		double real;
	} above = { UINT64_C(0x433) << 52 | bits >> 12 };

	return (above.real - 0x1p52 + 0.5) * 0x1p-52;
}

double ts_rng_uniform(struct ts_rng *rng)
{
	uint64_t bits[2];

	draw_words(rng, bits);
	return to_open_unit_interval(bits[0]);
}

TS_CLONES static void draw_of_streams(uint64_t seed, uint64_t counter, const int32_t stream[], size_t n,
				      double out[])
{
#pragma omp simd
	for (size_t i = 0; i < n; i++) {
		const uint64_t s = (uint64_t)stream[i];
		uint32_t w0 = (uint32_t)counter, w1 = (uint32_t)(counter >> 32), w2 = (uint32_t)s,
			 w3 = (uint32_t)(s >> 32);

		philox(&w0, &w1, &w2, &w3, (uint32_t)seed, (uint32_t)(seed >> 32));
		out[i] = to_open_unit_interval((uint64_t)w1 << 32 | w0);
	}
}

void ts_rng_uniform_of_streams(uint64_t seed, uint64_t counter, const int32_t stream[], size_t n,
			       double out[])
{
	draw_of_streams(seed, counter, stream, n, out);
}

double ts_rng_normal(struct ts_rng *rng)
{
	uint64_t bits[2];

	/* Box, Muller, Ann. Math. Stat. 29, 610 (1958) */
	draw_words(rng, bits);
	return sqrt(-2 * log(to_open_unit_interval(bits[0]))) *
	       cos(2 * acos(-1.0) * to_open_unit_interval(bits[1]));
}
