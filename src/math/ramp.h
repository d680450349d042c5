/* A quantity that varies linearly between two coordinates. */
#ifndef TS_MATH_RAMP_H
#define TS_MATH_RAMP_H

#include <math.h>

/* value[0] at coordinate end[0] and beyond, value[1] at end[1] and beyond, linear between them; the ends differ. */
static inline double ts_ramp(double x, const double end[2], const double value[2])
{
	const double part = fmin(1, fmax(0, (x - end[0]) / (end[1] - end[0])));

	return value[0] + part * (value[1] - value[0]);
}

#endif
