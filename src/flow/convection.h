/* Convection schemes: the value that is convected through the side between two points. */
#ifndef TS_FLOW_CONVECTION_H
#define TS_FLOW_CONVECTION_H

#include <math.h>

#include "base/inline.h"
#include "flow/operators.h"

/* CUBISTA, a bounded QUICK: Alves, Oliveira & Pinho, Int. J. Numer. Meth. Fluids 41 (2003) 47. `far` and
 * `near` are the second and the first point upstream. Third order in smooth flow; the value lies between
 * near and downstream. */
TS_INLINE double ts_convection_cubista(double far, double near, double downstream)
{
	double a = near - far, b = downstream - near, size_a = fabs(a), size_b = fabs(b);
	double least = 0.75 * (size_a < size_b ? size_a : size_b);
	double quick = 0.125 * size_a + 0.375 * size_b;
	double step = quick < least ? quick : least;

	return near + (a * b > 0 ? copysign(step, b) : 0);
}

/* The value on side m. far_low, low, high, far_high: values at points m - 2 .. m + 1; side m lies between
 * low and high; q: velocity through it; part: weight of `low` in linear interpolation. */
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
		double down = line->down[0][m] * far_high + line->down[1][m] * high + line->down[2][m] * low;

		return q > 0 ? up : down;
	}
	return q > 0 ? ts_convection_cubista(far_low, low, high) : ts_convection_cubista(far_high, high, low);
}

/* - q du/dx by finite differences, a fraction gamma of it upwind and the rest central. up, down:
 * differences to the points above and below; 1/distance to them is above/inverse and below/inverse. */
TS_INLINE double ts_convection_difference(enum ts_convection scheme, double gamma, double q, double up,
					  double down, double above, double below, double inverse)
{
	double upwind = scheme == TS_CONVECTION_DONOR ? gamma : 0;
	double slope_up = up * above / inverse, slope_down = down * below / inverse;
	/* The slope at the middle of the parabola through three points: each one-sided slope has the
	 * distance of the other side as weight. */
	double central = (slope_up * above + slope_down * below) / (above + below);

	return -q * ((1 - upwind) * central + upwind * (q > 0 ? slope_down : slope_up));
}

#endif
