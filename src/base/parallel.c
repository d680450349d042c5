#include "base/parallel.h"

#include "base/banned.h"

static size_t range_begin(size_t n, int k, int threads)
{
	return n * (size_t)k / (size_t)threads;
}

void ts_parallel(int threads, size_t n, ts_range_fn *loop, void *context)
{
	if (threads == 1) {
		loop(context, 0, n);
		return;
	}
#pragma omp parallel for num_threads(threads) schedule(static, 1)
	for (int k = 0; k < threads; k++)
		loop(context, range_begin(n, k, threads), range_begin(n, k + 1, threads));
}

long ts_parallel_count(int threads, size_t n, ts_range_count_fn *loop, void *context)
{
	long total = 0;

	if (threads == 1)
		return loop(context, 0, n);
#pragma omp parallel for num_threads(threads) schedule(static, 1) reduction(+ : total)
	for (int k = 0; k < threads; k++)
		total += loop(context, range_begin(n, k, threads), range_begin(n, k + 1, threads));
	return total;
}
