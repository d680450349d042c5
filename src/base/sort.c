#include "base/sort.h"

#include <string.h>

#include "base/clones.h"
#include "base/four.h"

#include "base/banned.h"

#define COMPARE(name, type)                                            \
	int name(const void *a, const void *b)                         \
	{                                                              \
		const type x = *(const type *)a, y = *(const type *)b; \
                                                                       \
		return (x > y) - (x < y);                              \
	}
COMPARE(ts_compare_int32, int32_t)
COMPARE(ts_compare_int64, int64_t)
COMPARE(ts_compare_double, double)
#undef COMPARE

int ts_compare_int32_pair(const void *a, const void *b)
{
	const int32_t *p = a, *q = b;
	int first = ts_compare_int32(p, q);

	return first ? first : ts_compare_int32(p + 1, q + 1);
}

size_t ts_find_int32(const void *sorted, size_t n, size_t size, int32_t number)
{
	size_t lo = 0, hi = n;

	while (lo < hi) {
		size_t middle = lo + (hi - lo) / 2;

		if (ts_compare_int32((const char *)sorted + middle * size, &number) < 0)
			lo = middle + 1;
		else
			hi = middle;
	}
	return lo;
}

enum { SHORT = 32, WIDE = 8 };

/* Rank sort: the position of a key is the number of smaller keys. It needs more comparisons than other
 * methods, but they are vectorised and have no branches. */
TS_CLONES static void sort_short(uint64_t *key, size_t n)
{
	/* older instruction sets compare only signed integers in vectors */
	const uint64_t sign = (uint64_t)1 << 63;
	union {
		ts_four_marks four[SHORT / 4];
		long long one[SHORT];
	} mine, rank;

	for (size_t k = 0; k < n; k++)
		mine.one[k] = (long long)(key[k] ^ sign);
	for (size_t k = 0; k < n; k += WIDE) {
		ts_four_marks a = { 0 }, b = { 0 };

		for (size_t j = 0; j < n; j++) {
			const long long one = mine.one[j];
			const ts_four_marks all = { one, one, one, one };

			a -= all < mine.four[k / 4];
			b -= all < mine.four[k / 4 + 1];
		}
		rank.four[k / 4] = a;
		rank.four[k / 4 + 1] = b;
	}
	for (size_t k = 0; k < n; k++)
		key[rank.one[k]] = (uint64_t)mine.one[k] ^ sign;
}

/* Merges two adjacent sorted lists of n and m keys. */
static void merge_lists(const uint64_t *key, size_t n, size_t m, uint64_t *out)
{
	size_t a = 0, b = n;

	while (a < n && b < n + m)
		*out++ = key[a] <= key[b] ? key[a++] : key[b++];
	while (a < n)
		*out++ = key[a++];
	while (b < n + m)
		*out++ = key[b++];
}

void ts_sort_keys(uint64_t *key, uint64_t *spare, size_t n)
{
	for (size_t k = 0; k < n; k += SHORT)
		sort_short(key + k, n - k < SHORT ? n - k : SHORT);
	for (size_t width = SHORT; width < n; width *= 2) {
		for (size_t k = 0; k < n; k += 2 * width) {
			size_t left = n - k < width ? n - k : width;
			size_t right = n - k - left < width ? n - k - left : width;

			merge_lists(key + k, left, right, spare + k);
		}
		memcpy(key, spare, n * sizeof *key);
	}
}

/* Radix sort, from the lowest digits on; digits that are the same in all keys are left out. */
void ts_sort_equal_keys(uint64_t *key, uint64_t *spare, size_t n)
{
	enum { BITS = 8, DIGITS = 1 << BITS };
	uint64_t *from = key, *to = spare;

	for (int shift = 0; shift < 64; shift += BITS) {
		size_t first[DIGITS + 1] = { 0 };
		uint64_t *sorted = to;

		for (size_t k = 0; k < n; k++)
			first[(from[k] >> shift & (DIGITS - 1)) + 1]++;
		if (n && first[(from[0] >> shift & (DIGITS - 1)) + 1] == n)
			continue;
		for (int digit = 0; digit < DIGITS; digit++)
			first[digit + 1] += first[digit];
		for (size_t k = 0; k < n; k++)
			to[first[from[k] >> shift & (DIGITS - 1)]++] = from[k];
		to = from;
		from = sorted;
	}
	if (from != key)
		memcpy(key, from, n * sizeof *key);
}
