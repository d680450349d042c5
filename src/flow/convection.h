/* Values of what is carried on the side between two points, by schemes of convection. */
#ifndef TS_FLOW_CONVECTION_H
#define TS_FLOW_CONVECTION_H

#include <math.h>

#include "base/inline.h"
#include "flow/operators.h"

/* Alves, Oliveira & Pinho, Int. J. Numer. Meth. Fluids 41 (2003) 47: QUICK, bounded. From the points upstream:
 * far, near, and the one downstream. Of third order where smooth; never beyond near and downstream. */
TS_INLINE double ts_convection_cubista(double far, double near, double downstream)
{
	double a = near - far, b = downstream - near, size_a = fabs(a), size_b = fabs(b);
	double least = 0.75 * (size_a < size_b ? size_a : size_b);
	double quick = 0.125 * size_a + 0.375 * size_b;
	double step = quick < least ? quick : least;

	return near + (a * b > 0 ? copysign(step, b) : 0);
}

/* Points m - 2 .. m + 1 of the line are far_low, low, high, far_high; the side m is between low and high; q is the
 * velocity through it. */
TS_INLINE double ts_convection_face_value(enum ts_convection scheme, double gamma, double q, double far_low,
			       double low, double high, double far_high, double part,
			       const struct ts_operator_line *line, int m)
{
	double central = part * low + (1 - part) * high;

	if (scheme == TS_CONVECTION_CENTRAL)
		return central;
	if (scheme == TS_CONVECTION_DONOR)
		return (1 - gamma) * central + gamma * (q > 0 ? low : high);
	if (scheme == TS_CONVECTION_QUICK) {
		double up = line->up[0][m] * far_low + line->up[1][m] * low + line->up[2][m] * high;
		double down = line->down[0][m] * far_high + line->down[1][m] * high +
			      line->down[2][m] * low;

		return q > 0 ? up : down;
	}
	return q > 0 ? ts_convection_cubista(far_low, low, high) : ts_convection_cubista(far_high, high, low);
}

/* - q du/dx by finite differences: gamma of it upwind, the rest central. Differences above and below the
 * point; 1/distance above = above/inverse, likewise below. */
TS_INLINE double ts_convection_difference(enum ts_convection scheme, double gamma, double q, double up,
			      double down, double above, double below, double inverse)
{
	double share = scheme == TS_CONVECTION_DONOR ? gamma : 0;
	double slope_up = up * above / inverse, slope_down = down * below / inverse;
	/* The slope of the parabola through three points: each weighs with the distance of the other. */
	double central = (slope_up * above + slope_down * below) / (above + below);

	return -q * ((1 - share) * central + share * (q > 0 ? slope_down : slope_up));
}

#endif
