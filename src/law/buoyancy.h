/* Volume of a sphere, or area of a disc, below the surface of a fluid. At the depth h (0 .. 2 R) of its
 * lowest point: the spherical cap pi h^2 (3 R - h)/3; the circular segment R^2 acos(1 - h/R) - (R - h)
 * sqrt(2 R h - h^2). */
#ifndef TS_LAW_BUOYANCY_H
#define TS_LAW_BUOYANCY_H

#include <math.h>
#include <stdbool.h>

#include "law/lens.h"
#include "math/constants.h"

static inline double ts_buoyancy_immersed_volume(double radius, double depth, bool disc)
{
	double h = fmin(fmax(depth, 0), 2 * radius);

	if (disc)
		return radius * radius * acos(1 - h / radius) - (radius - h) * sqrt(h * (2 * radius - h));
	return TS_PI / 3 * h * h * (3 * radius - h);
}

#endif
