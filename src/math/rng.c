#include "math/rng.h"

#include <math.h>

#include "base/banned.h"

void ts_rng_philox(const uint32_t counter[4], const uint32_t key[2], uint32_t out[4])
{
	uint32_t k0 = key[0], k1 = key[1];

	for (int i = 0; i < 4; i++)
		out[i] = counter[i];
	for (int round = 0; round < 10; round++) {
		uint64_t a = UINT64_C(0xd2511f53) * out[0], b = UINT64_C(0xcd9e8d57) * out[2];
		uint32_t x1 = out[1], x3 = out[3];

		out[0] = (uint32_t)(b >> 32) ^ x1 ^ k0;
		out[1] = (uint32_t)b;
		out[2] = (uint32_t)(a >> 32) ^ x3 ^ k1;
		out[3] = (uint32_t)a;
		k0 += 0x9e3779b9u;
		k1 += 0xbb67ae85u;
	}
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
static double to_open_unit_interval(uint64_t bits)
{
	return ((double)(bits >> 12) + 0.5) * 0x1p-52;
}

double ts_rng_uniform(struct ts_rng *rng)
{
	uint64_t bits[2];

	draw_words(rng, bits);
	return to_open_unit_interval(bits[0]);
}

double ts_rng_normal(struct ts_rng *rng)
{
	uint64_t bits[2];

	/* Box, Muller, Ann. Math. Stat. 29, 610 (1958) */
	draw_words(rng, bits);
	return sqrt(-2 * log(to_open_unit_interval(bits[0]))) *
	       cos(2 * acos(-1.0) * to_open_unit_interval(bits[1]));
}
