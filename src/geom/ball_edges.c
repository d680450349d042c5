#include "base/clones.h"
TS_UNROLLED
#include "geom/ball_edges.h"

#include <math.h>

#include "base/banned.h"

/* The arithmetic is that of positive_edge_volume of ball_corner.c. */

TS_INLINE double root_of_positive(double x)
{
	return sqrt(x > 0 ? x : 0);
}

TS_CLONES
static void find_cosines(struct ts_ball_edges *e, size_t n)
{
#pragma omp simd
	for (size_t k = 0; k < n; k++) {
		const double a = e->a[k], b = e->b[k], sa = 1 - a * a, sb = 1 - b * b;

		e->angle[0][k] = ts_ball_clamp(b / sqrt(sa));
		e->angle[1][k] = ts_ball_clamp(a / sqrt(sb));
		e->angle[2][k] = ts_ball_clamp(-a * b / sqrt(sa * sb));
	}
}

TS_CLONES
static void find_volumes(struct ts_ball_edges *e, size_t n)
{
	static const double right = TS_PI / 2;

#pragma omp simd
	for (size_t k = 0; k < n; k++) {
		const double a = e->a[k], b = e->b[k], sa = 1 - a * a, sb = 1 - b * b;
		const double ta = e->angle[0][k], tb = right - e->angle[1][k];
		const double flat = a * (0.5 * (sa * ta - b * root_of_positive(sa - b * b))) +
				    b * (0.5 * (sb * tb - a * root_of_positive(sb - a * a)));
		const double round = 2 * TS_PI - e->angle[2][k] - right - right - a * ta - b * tb;
		const double volume = (round - flat) / 3;

		e->volume[k] = a * a + b * b >= 1 ? 0 : volume > 0 ? volume : 0;
	}
}

void ts_ball_edges_find(struct ts_ball_edges *e, size_t n)
{
	find_cosines(e, n);
	for (size_t k = 0; k < n; k++)
		e->angle[0][k] = acos(e->angle[0][k]);
	for (size_t k = 0; k < n; k++)
		e->angle[1][k] = asin(e->angle[1][k]);
	for (size_t k = 0; k < n; k++)
		e->angle[2][k] = acos(e->angle[2][k]);
	find_volumes(e, n);
}
