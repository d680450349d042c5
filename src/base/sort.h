/* Sorting of short lists of whole numbers. */
#ifndef TS_BASE_SORT_H
#define TS_BASE_SORT_H

#include <stddef.h>
#include <stdint.h>

/* Any number of keys that differ, in ascending order; `spare` has room for as many. */
void ts_sort_keys(uint64_t *key, uint64_t *spare, size_t n);

#endif
