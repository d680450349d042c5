#include "math/bounds.h"

#include <math.h>

#include "base/clones.h"
#include "base/parallel.h"

#include "base/banned.h"

struct bounds {
	const double (*x)[3];
	double *lo, *hi;
};

static void clear(double lo[3], double hi[3])
{
	for (int d = 0; d < 3; d++) {
		lo[d] = INFINITY;
		hi[d] = -INFINITY;
	}
}

TS_CLONES static void enclose(const double (*x)[3], size_t from, size_t to, double lo[3], double hi[3])
{
	for (size_t i = from; i < to; i++)
		for (int d = 0; d < 3; d++) {
			lo[d] = x[i][d] < lo[d] ? x[i][d] : lo[d];
			hi[d] = x[i][d] > hi[d] ? x[i][d] : hi[d];
		}
}

static void enclose_share(void *context, size_t from, size_t to)
{
	const struct bounds *b = context;
	double lo[3], hi[3];

	clear(lo, hi);
	enclose(b->x, from, to, lo, hi);
#pragma omp critical(ts_bounds)
	for (int d = 0; d < 3; d++) {
		b->lo[d] = fmin(b->lo[d], lo[d]);
		b->hi[d] = fmax(b->hi[d], hi[d]);
	}
}

void ts_bounds(int team, size_t n, const double (*x)[3], double lo[3], double hi[3])
{
	struct bounds bounds = { x, lo, hi };

	clear(lo, hi);
	ts_parallel(team, n, enclose_share, &bounds);
}
