/* Parallel loops over ranges. Simple loops over particles in styles use `#pragma omp parallel for`;
 * loops that are instantiated for many laws, or that count, use these functions.
 *
 * A range function computes the indices from .. to-1. Ranges are contiguous and write to separate
 * places, so results do not depend on the number of threads; sums over ranges are formed only where the
 * order does not matter (counts). */
#ifndef TS_BASE_PARALLEL_H
#define TS_BASE_PARALLEL_H

#include <stddef.h>

typedef void ts_range_fn(void *context, size_t from, size_t to);

/* Calls `loop` for the indices 0 .. n-1, divided into `threads` ranges, in parallel. */
void ts_parallel(int threads, size_t n, ts_range_fn *loop, void *context);

/* The same for functions that count; returns the total. */
typedef long ts_range_count_fn(void *context, size_t from, size_t to);
long ts_parallel_count(int threads, size_t n, ts_range_count_fn *loop, void *context);

#endif
