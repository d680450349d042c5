#include "base/hash.h"

#include <string.h>

#include "base/banned.h"

static uint64_t mix(uint64_t h, uint64_t word)
{
	h = (h ^ word) * 0x9fb21c651e98df25u;
	return h ^ (h >> 32);
}

struct ts_hash ts_hash_start(void)
{
	return (struct ts_hash){ 0x243f6a8885a308d3u };
}

void ts_hash_add(struct ts_hash *hash, const void *bytes, size_t n)
{
	const unsigned char *p = bytes;
	uint64_t word;

	for (; n >= sizeof word; n -= sizeof word, p += sizeof word) {
		memcpy(&word, p, sizeof word);
		hash->state = mix(hash->state, word);
	}
	word = n;
	if (n)
		memcpy(&word, p, n);
	hash->state = mix(hash->state, word ^ ((uint64_t)n << 56));
}

void ts_hash_text(struct ts_hash *hash, const char *text)
{
	ts_hash_add(hash, text, strlen(text) + 1);
}

uint64_t ts_hash_value(const struct ts_hash *hash)
{
	return mix(hash->state, 0x452821e638d01377u);
}

/* The first n bytes of a word, whose others are 0. Most are one number of 32 bits, for which a copy of any length takes ten times
 * as long. */
static inline uint64_t part_of_word(const unsigned char *p, size_t n)
{
	uint64_t word = 0;
	uint32_t half;

	if (n == sizeof half) {
		memcpy(&half, p, sizeof half);
		return half;
	}
	memcpy(&word, p, n);
	return word;
}

uint64_t ts_hash_rows(const struct ts_hash *hash, const int32_t *key, const void *rows, size_t bytes,
		      size_t n)
{
	const size_t words = bytes / sizeof(uint64_t), rest = bytes % sizeof(uint64_t);
	const unsigned char *p = rows;
	uint64_t sum = 0;

	for (size_t i = 0; i < n; i++) {
		uint64_t word = (uint64_t)(uint32_t)key[i], state = hash->state + word * 0x9e3779b97f4a7c15u;

		for (size_t k = 0; k < words; k++, p += sizeof word) {
			memcpy(&word, p, sizeof word);
			state = mix(state, word);
		}
		if (rest) {
			state = mix(state, part_of_word(p, rest));
			p += rest;
		}
		sum += state;
	}
	return sum;
}
