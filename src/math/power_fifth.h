/* The power of 0.2, of which loops are vectorised, and whose bits do not depend on the processor: pow of the C library has other
 * last bits where the processor has no fused multiply-add. */
#ifndef TS_MATH_POWER_FIFTH_H
#define TS_MATH_POWER_FIFTH_H

#include <stdint.h>
#include <string.h>

#include "base/inline.h"

/* The error of the rounded product p of a and b. (T. J. Dekker, Numer. Math. 18, 224, 1971) */
TS_INLINE double ts_product_error(double a, double b, double p)
{
	const double split = 134217729; /* 2^27 + 1 */
	double ta = split * a, tb = split * b, a1 = ta - (ta - a), b1 = tb - (tb - b), a0 = a - a1,
	       b0 = b - b1;

	return ((a1 * b1 - p) + a1 * b0 + a0 * b1) + a0 * b0;
}

/* pow(x, 0.2) within 0.52 units of the last place, for 1e-240 < x < 1e240; not x^(1/5), since the double 0.2 is larger than 1/5
 * by EXCESS. The upper 32 bits of a double are nearly 2^20 times its binary logarithm plus a constant, so that a fifth of
 * them, plus four fifths of the constant, is the root within 4 %. Two steps of Halley, each of which cubes the error, make it
 * 1e-12, and one of Newton some units of the last place; the last step has x - y^5 in twofold precision. */
TS_INLINE double ts_power_fifth(double x)
{
	const double start = (0.8 * 1023 - 0.035) * 1048576;		   /* 0.035: least error */
	const double excess = 1.1102230246251565e-17 * 0.6931471805599453; /* by ln 2 */
	int64_t bits;
	int32_t upper;
	double y, y2, y4, y5, e2, e4, e5, f, logarithm;

	memcpy(&bits, &x, sizeof bits);
	upper = (int32_t)(bits >> 32);
	f = (upper & 1048575) * (1.0 / 1048576);
	logarithm = (upper >> 20) - 1023 + f * (1.3465 - 0.3465 * f); /* to base 2, within 0.008 */
	bits = (int64_t)(int32_t)(0.2 * upper + start) << 32;
	memcpy(&y, &bits, sizeof y);
	for (int k = 0; k < 2; k++) {
		y5 = y * y * (y * y) * y;
		y *= (2 * y5 + 3 * x) / (3 * y5 + 2 * x);
	}
	y2 = y * y;
	y4 = y2 * y2;
	y += (x - y4 * y) / (5 * y4);
	y2 = y * y;
	e2 = ts_product_error(y, y, y2);
	y4 = y2 * y2;
	e4 = ts_product_error(y2, y2, y4) + 2 * y2 * e2;
	y5 = y4 * y;
	e5 = ts_product_error(y4, y, y5) + e4 * y;
	return y + (((x - y5) - e5) / (5 * y4) + y * (excess * logarithm));
}

#endif
