/* Sorting. */
#ifndef TS_BASE_SORT_H
#define TS_BASE_SORT_H

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

/* For ts_sort and bsearch: numbers in ascending order; of elements that begin with a number, by it. */
int ts_compare_int32(const void *a, const void *b);
int ts_compare_int64(const void *a, const void *b);
int ts_compare_double(const void *a, const void *b);
/* The same for elements that begin with two numbers: by the first one, then by the second one. */
int ts_compare_int32_pair(const void *a, const void *b);

/* Index of the first of n elements of `size` bytes that begins with a number not less than this one; n: there is none. The
 * elements are sorted by ts_compare_int32. */
size_t ts_find_int32(const void *sorted, size_t n, size_t size, int32_t number);

/* Sorts n distinct keys in ascending order; `spare`: scratch memory for n keys. */
void ts_sort_keys(uint64_t *key, uint64_t *spare, size_t n);

/* Sorts n keys, some of which may be equal, in ascending order. */
void ts_sort_equal_keys(uint64_t *key, uint64_t *spare, size_t n);

/* qsort, whose array may not be NULL; here it may, if there is nothing to sort. */
static inline void ts_sort(void *base, size_t n, size_t size, int (*compare)(const void *, const void *))
{
	if (n > 1)
		qsort(base, n, size, compare);
}

#endif
