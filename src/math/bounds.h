/* The smallest box around vectors. */
#ifndef TS_MATH_BOUNDS_H
#define TS_MATH_BOUNDS_H

#include <stddef.h>

/* Sets the box around the n vectors, lo > hi (infinite) if there are none, by `team` threads. NaN is left out. */
void ts_bounds(int team, size_t n, const double (*x)[3], double lo[3], double hi[3]);

#endif
