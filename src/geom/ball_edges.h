/* Volumes of the unit ball beyond edges, many at once in vectors: bitwise those of geom/ball_corner.h. */
#ifndef TS_GEOM_BALL_EDGES_H
#define TS_GEOM_BALL_EDGES_H

#include <stddef.h>

#include "base/inline.h"
#include "math/constants.h"

enum { TS_BALL_EDGES = 96 }; /* most of them */

struct ts_ball_edges {
	double a[TS_BALL_EDGES], b[TS_BALL_EDGES];
	double volume[TS_BALL_EDGES];	/* of x >= a, y >= b, z >= 0 with a, b >= 0 */
	double angle[3][TS_BALL_EDGES]; /* work: cosines, and angles */
};

/* Sets volume[0] .. volume[n - 1]. */
void ts_ball_edges_find(struct ts_ball_edges *edges, size_t n);

/* Within the ball: cosines, and coordinates of planes. */
TS_INLINE double ts_ball_clamp(double x)
{
	return x < -1 ? -1 : x > 1 ? 1 : x;
}

/* Volume of x >= a. */
TS_INLINE double ts_ball_cap(double a)
{
	a = ts_ball_clamp(a);
	return TS_PI / 3 * (1 - a) * (1 - a) * (2 + a);
}

#endif
