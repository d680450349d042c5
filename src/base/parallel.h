/* Loops shared among threads. Plain loops over particles in styles say `#pragma omp parallel for`
 * themselves; loops that are written once for many laws, or that count, come through here.
 *
 * A share is a function over a range of indices. Ranges are contiguous and shares write to places of
 * their own, so results do not depend on the number of threads; sums are made of per-share parts only
 * where order does not matter (counts). */
#ifndef TS_BASE_PARALLEL_H
#define TS_BASE_PARALLEL_H

#include <stddef.h>

typedef void ts_range_fn(void *context, size_t from, size_t to);

/* Calls share for 0..n-1 cut into `threads` ranges, side by side. */
void ts_parallel(int threads, size_t n, ts_range_fn *share, void *context);

/* The same for shares that count; returns the total. */
typedef long ts_range_count_fn(void *context, size_t from, size_t to);
long ts_parallel_count(int threads, size_t n, ts_range_count_fn *share, void *context);

#endif
