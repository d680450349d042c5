/* Streaming bandwidth of one thread: a = b + 3 c over arrays far larger than the caches (the triad of
 * J. D. McCalpin's STREAM). Prints GB/s, the best of several passes. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now(void)
{
	struct timespec t;

	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(void)
{
	size_t n = (size_t)1 << 23;
	double *a = malloc(n * sizeof *a), *b = malloc(n * sizeof *b), *c = malloc(n * sizeof *c);
	double best = 0;

	if (!a || !b || !c)
		return 1;
	for (size_t i = 0; i < n; i++) {
		a[i] = 0;
		b[i] = (double)i;
		c[i] = 1;
	}
	for (int pass = 0; pass < 8; pass++) {
		double start = now(), rate;

		for (size_t i = 0; i < n; i++)
			a[i] = b[i] + 3 * c[i];
		rate = 24e-9 * (double)n / (now() - start);
		best = rate > best ? rate : best;
	}
	printf("%.3g\n", a[n / 2] > 0 ? best : 0);
	return 0;
}
