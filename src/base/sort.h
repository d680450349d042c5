/* Sorting of integer keys. */
#ifndef TS_BASE_SORT_H
#define TS_BASE_SORT_H

#include <stddef.h>
#include <stdint.h>

/* Sorts n distinct keys in ascending order; `spare`: scratch memory for n keys. */
void ts_sort_keys(uint64_t *key, uint64_t *spare, size_t n);

#endif
