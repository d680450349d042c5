/* Sorting of short lists of whole numbers. */
#ifndef TS_BASE_SORT_H
#define TS_BASE_SORT_H

#include <stddef.h>
#include <stdint.h>

static inline void ts_sort_by_insertion(uint64_t *key, size_t n)
{
	for (size_t k = 1; k < n; k++) {
		uint64_t mine = key[k];
		size_t at = k;

		for (; at && key[at - 1] > mine; at--)
			key[at] = key[at - 1];
		key[at] = mine;
	}
}

/* Any number of keys, in ascending order; `spare` has room for as many. */
void ts_sort_keys(uint64_t *key, uint64_t *spare, size_t n);

#endif
