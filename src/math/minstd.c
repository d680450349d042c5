#include "math/minstd.h"

#include <math.h>

#include "base/banned.h"

double ts_minstd_normal(struct ts_minstd *r)
{
	double a, b, square, factor;

	if (r->has_spare) {
		r->has_spare = 0;
		return r->spare;
	}
	do {
		a = 2 * ts_minstd_uniform(r) - 1;
		b = 2 * ts_minstd_uniform(r) - 1;
		square = a * a + b * b;
	} while (square >= 1 || square == 0);
	factor = sqrt(-2 * log(square) / square);
	r->spare = a * factor;
	r->has_spare = 1;
	return b * factor;
}

bool ts_minstd_is_prime(int64_t n)
{
	if (n < 2)
		return false;
	for (int64_t d = 2; d <= n / d; d++)
		if (n % d == 0)
			return false;
	return true;
}
