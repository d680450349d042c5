/* Fifth root, of which loops are vectorised, and whose bits do not depend on the processor: pow of the C library has other
 * last bits where the processor has no fused multiply-add. */
#ifndef TS_MATH_FIFTH_ROOT_H
#define TS_MATH_FIFTH_ROOT_H

#include <stdint.h>
#include <string.h>

#include "base/inline.h"

/* x^(1/5) within 1.1 units of the last place, for 2.3e-308 < x < 1e307. The upper 32 bits of a double are nearly 2^20 times
 * its binary logarithm plus a constant, so that a fifth of them, plus four fifths of the constant, is the root within 4 %.
 * Two steps of Halley, each of which cubes the error, make it 1e-12, and one of Newton the rest. */
TS_INLINE double ts_fifth_root(double x)
{
	const double start = (0.8 * 1023 - 0.035) * 1048576; /* 0.035: least error */
	int64_t bits;
	double y, y4;

	memcpy(&bits, &x, sizeof bits);
	bits = (int64_t)(int32_t)(0.2 * (double)(int32_t)(bits >> 32) + start) << 32;
	memcpy(&y, &bits, sizeof y);
	for (int k = 0; k < 2; k++) {
		double y5 = y * y * (y * y) * y;

		y *= (2 * y5 + 3 * x) / (3 * y5 + 2 * x);
	}
	y4 = y * y * (y * y);
	return y + (x - y4 * y) / (5 * y4);
}

#endif
