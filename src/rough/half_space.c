#include "rough/half_space.h"

#include <math.h>

#include "math/constants.h"

#include "base/banned.h"

/* The indefinite integral of 1/r over x and y. */
static double integral(double x, double y)
{
	return (x != 0 ? x * asinh(y / fabs(x)) : 0) + (y != 0 ? y * asinh(x / fabs(y)) : 0);
}

static double rectangle(const void *context, int i, int j)
{
	const struct ts_half_space_grid *g = context;
	double left = (i - 0.5) * g->width[0], right = (i + 0.5) * g->width[0];
	double low = (j - 0.5) * g->width[1], high = (j + 0.5) * g->width[1];

	return (integral(right, high) - integral(left, high) - integral(right, low) + integral(left, low)) /
	       (TS_PI * g->modulus);
}

static double wave(const void *context, int k, int l)
{
	const struct ts_half_space_grid *g = context;
	double q = 2 * TS_PI * hypot(k / (g->n[0] * g->width[0]), l / (g->n[1] * g->width[1]));

	return q > 0 ? 2 / (g->modulus * q) : 0;
}

static bool same_grid(const struct ts_half_space_grid *a, const struct ts_half_space_grid *b)
{
	bool same = a->periodic == b->periodic && !(a->modulus < b->modulus) && !(a->modulus > b->modulus);

	for (int d = 0; d < 2; d++)
		same &= a->n[d] == b->n[d] && !(a->width[d] < b->width[d]) && !(a->width[d] > b->width[d]);
	return same;
}

enum ts_status ts_half_space_make(struct ts_half_space *h, const struct ts_half_space_grid *grid, int threads)
{
	if (h->made && same_grid(&h->grid, grid)) {
		h->compliance.threads = threads;
		return TS_OK;
	}
	ts_half_space_release(h);
	h->grid = *grid;
	TS_TRY(ts_convolution_make(&h->compliance, grid->n, grid->periodic, threads));
	if (grid->periodic)
		ts_convolution_set_spectrum(&h->compliance, wave, grid);
	else
		TS_TRY(ts_convolution_set_kernel(&h->compliance, rectangle, grid));
	h->made = true;
	return TS_OK;
}

void ts_half_space_release(struct ts_half_space *h)
{
	ts_convolution_release(&h->compliance);
	h->made = false;
}

enum ts_status ts_half_space_displace(struct ts_half_space *h, const double *pressure, double *displacement)
{
	return ts_convolution_apply(&h->compliance, pressure, displacement);
}
