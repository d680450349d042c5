#include "voxel/voxel_gaussian.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_fft_complex.h>
#include <math.h>

#include "base/alloc.h"
#include "math/constants.h"

#include "base/banned.h"

/* Square root of the discrete spectrum along one axis, with the sum of spectrum[k] equal to n, so that the
 * filtered noise has the variance of the noise. By Poisson's summation formula the transform of the sampled
 * and periodic covariance exp(-(r/l)^2) is the sum over all aliases q = 2 pi (k + m n)/L of exp(-(q l/2)^2). */
static void fill_amplitudes(int64_t n, double width, double length, double *amplitude)
{
	/* below 0.03 widths the covariance of neighbours, exp(-1111), is 0 in double precision */
	bool correlated = length > 0.03 * width;
	double sum = 0, unit = TS_PI * length / ((double)n * width);
	/* of aliases farther away exp underflows */
	int64_t most = correlated ? (int64_t)ceil(28 / (unit * (double)n)) : 0;

	for (int64_t k = 0; k < n; k++) {
		double spectrum = 0;

		for (int64_t m = -most - 1; m <= most; m++) {
			double q = correlated ? unit * (double)(k + m * n) : 0;

			spectrum += exp(-q * q);
		}
		amplitude[k] = spectrum;
		sum += spectrum;
	}
	for (int64_t k = 0; k < n; k++)
		amplitude[k] = sqrt(amplitude[k] * (double)n / sum);
}

/* The tables of the transforms along both axes. */
struct transform {
	gsl_fft_complex_wavetable *table[2];
	gsl_fft_complex_workspace *work[2];
	double *complex; /* [n[1]][n[0]][2] */
	double *amplitude[2];
};

static void release(struct transform *t)
{
	for (int d = 0; d < 2; d++) {
		if (t->table[d])
			gsl_fft_complex_wavetable_free(t->table[d]);
		if (t->work[d])
			gsl_fft_complex_workspace_free(t->work[d]);
		ts_free(t->amplitude[d]);
	}
	ts_free(t->complex);
}

static bool prepare(const struct ts_voxel_gaussian *g, struct transform *t)
{
	bool good;

	t->complex = ts_alloc((size_t)g->n[0] * (size_t)g->n[1], 2 * sizeof *t->complex);
	good = t->complex != NULL;
	for (int d = 0; d < 2; d++) {
		t->table[d] = gsl_fft_complex_wavetable_alloc((size_t)g->n[d]);
		t->work[d] = gsl_fft_complex_workspace_alloc((size_t)g->n[d]);
		t->amplitude[d] = ts_alloc((size_t)g->n[d], sizeof *t->amplitude[d]);
		good &= t->table[d] && t->work[d] && t->amplitude[d];
	}
	return good;
}

static bool transform_all(const struct ts_voxel_gaussian *g, struct transform *t, gsl_fft_direction sign)
{
	size_t nx = (size_t)g->n[0], ny = (size_t)g->n[1];
	bool good = true;

	for (size_t j = 0; j < ny; j++)
		good &= gsl_fft_complex_transform(t->complex + 2 * j * nx, 1, nx, t->table[0], t->work[0],
						  sign) == GSL_SUCCESS;
	for (size_t i = 0; i < nx; i++)
		good &= gsl_fft_complex_transform(t->complex + 2 * i, nx, ny, t->table[1], t->work[1],
						  sign) == GSL_SUCCESS;
	return good;
}

static bool filter(const struct ts_voxel_gaussian *g, struct transform *t, double *noise)
{
	size_t nx = (size_t)g->n[0], n = nx * (size_t)g->n[1];

	if (!prepare(g, t))
		return false;
	for (int d = 0; d < 2; d++)
		fill_amplitudes(g->n[d], g->width[d], g->correlation[d], t->amplitude[d]);
	for (size_t k = 0; k < n; k++)
		t->complex[2 * k] = noise[k];
	if (!transform_all(g, t, gsl_fft_forward))
		return false;
	for (size_t k = 0; k < 2 * n; k++)
		t->complex[k] *= t->amplitude[0][k / 2 % nx] * t->amplitude[1][k / 2 / nx];
	if (!transform_all(g, t, gsl_fft_backward))
		return false;
	for (size_t k = 0; k < n; k++)
		noise[k] = t->complex[2 * k] / (double)n;
	return true;
}

enum ts_status ts_voxel_gaussian_filter(const struct ts_voxel_gaussian *g, double *noise)
{
	gsl_error_handler_t *handler = gsl_set_error_handler_off();
	struct transform t = { 0 };
	bool good = filter(g, &t, noise);

	release(&t);
	gsl_set_error_handler(handler);
	return good ? TS_OK : TS_NOMEM;
}

void ts_voxel_normalise(double *value, size_t n)
{
	double mean = 0, square = 0;

	for (size_t k = 0; k < n; k++)
		mean += value[k];
	mean /= (double)n;
	for (size_t k = 0; k < n; k++) {
		value[k] -= mean;
		square += value[k] * value[k];
	}
	for (size_t k = 0; k < n; k++)
		value[k] /= sqrt(square / (double)n);
}

enum ts_status ts_voxel_gaussian(const struct ts_voxel_gaussian *g, double *height)
{
	size_t n = (size_t)g->n[0] * (size_t)g->n[1];

	TS_TRY(ts_voxel_noise(g->noise, g->seed, (int[2]){ (int)g->n[0], (int)g->n[1] }, height));
	TS_TRY(ts_voxel_gaussian_filter(g, height));
	if (g->exact)
		ts_voxel_normalise(height, n);
	for (size_t k = 0; k < n; k++)
		height[k] = g->mean + g->deviation * height[k];
	return TS_OK;
}
