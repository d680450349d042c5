/* Sorting. */
#ifndef TS_BASE_SORT_H
#define TS_BASE_SORT_H

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

/* Sorts n distinct keys in ascending order; `spare`: scratch memory for n keys. */
void ts_sort_keys(uint64_t *key, uint64_t *spare, size_t n);

/* qsort, whose array may not be NULL; here it may, if there is nothing to sort. */
static inline void ts_sort(void *base, size_t n, size_t size, int (*compare)(const void *, const void *))
{
	if (n > 1)
		qsort(base, n, size, compare);
}

#endif
