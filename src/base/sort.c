#include "base/sort.h"

#include <string.h>

#include "base/banned.h"

enum { SHORT = 24 };

/* Two sorted lists that follow one another, of n and m keys. */
static void merge(const uint64_t *key, size_t n, size_t m, uint64_t *out)
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
		ts_sort_by_insertion(key + k, n - k < SHORT ? n - k : SHORT);
	for (size_t width = SHORT; width < n; width *= 2) {
		for (size_t k = 0; k < n; k += 2 * width) {
			size_t left = n - k < width ? n - k : width;
			size_t right = n - k - left < width ? n - k - left : width;

			merge(key + k, left, right, spare + k);
		}
		memcpy(key, spare, n * sizeof *key);
	}
}
