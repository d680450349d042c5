#include "rough/half_space.h"

#include <math.h>

#include "math/constants.h"

#include "base/banned.h"

struct grid {
	double width[2], modulus;
	int n[2];
};

/* The indefinite integral of 1/r over x and y. */
static double integral(double x, double y)
{
	return (x != 0 ? x * asinh(y / fabs(x)) : 0) + (y != 0 ? y * asinh(x / fabs(y)) : 0);
}

static double rectangle(const void *context, int i, int j)
{
	const struct grid *g = context;
	double left = (i - 0.5) * g->width[0], right = (i + 0.5) * g->width[0];
	double low = (j - 0.5) * g->width[1], high = (j + 0.5) * g->width[1];

	return (integral(right, high) - integral(left, high) - integral(right, low) + integral(left, low)) /
	       (TS_PI * g->modulus);
}

static double wave(const void *context, int k, int l)
{
	const struct grid *g = context;
	double q = 2 * TS_PI * hypot(k / (g->n[0] * g->width[0]), l / (g->n[1] * g->width[1]));

	return q > 0 ? 2 / (g->modulus * q) : 0;
}

enum ts_status ts_half_space_make(struct ts_half_space *h, const int n[2], const double width[2],
				  double modulus, bool periodic, int threads)
{
	const struct grid grid = { { width[0], width[1] }, modulus, { n[0], n[1] } };

	TS_TRY(ts_convolution_make(&h->compliance, n, periodic, threads));
	if (!periodic)
		return ts_convolution_set_kernel(&h->compliance, rectangle, &grid);
	ts_convolution_set_spectrum(&h->compliance, wave, &grid);
	return TS_OK;
}

void ts_half_space_release(struct ts_half_space *h)
{
	ts_convolution_release(&h->compliance);
}

enum ts_status ts_half_space_displace(struct ts_half_space *h, const double *pressure, double *displacement)
{
	return ts_convolution_apply(&h->compliance, pressure, displacement);
}
