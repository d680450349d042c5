#include "voxel/voxel_self_affine.h"

#include <math.h>

#include "base/alloc.h"
#include "math/constants.h"
#include "math/convolution.h"
#include "voxel/voxel_gaussian.h"

#include "base/banned.h"

struct filter {
	const struct ts_voxel_self_affine *surface;
	double factor; /* so that noise of variance 1 gives the deviation */
};

static double spectrum(const struct ts_voxel_self_affine *s, int k, int l)
{
	const double round = 1e-12; /* waves at a limit belong to the spectrum */
	double wave = 1 / hypot(k / (s->n[0] * s->width[0]), l / (s->n[1] * s->width[1]));

	if (wave > s->longest * (1 + round) || wave < s->shortest * (1 - round))
		return 0;
	return wave > s->roll ? 1 : pow(wave / s->roll, 2 + 2 * s->hurst);
}

static double amplitude(const void *context, int k, int l)
{
	const struct filter *filter = context;

	return k || l ? filter->factor * sqrt(spectrum(filter->surface, k, l)) : 0;
}

/* Mean over the waves of the grid: the variance of the filtered noise. */
static double variance(const struct ts_voxel_self_affine *s)
{
	double sum = 0;

	for (int l = 0; l < s->n[1]; l++)
		for (int k = 0; k < s->n[0]; k++)
			if (k || l)
				sum += spectrum(s, k < s->n[0] - k ? k : s->n[0] - k,
						l < s->n[1] - l ? l : s->n[1] - l);
	return sum / ((double)s->n[0] * (double)s->n[1]);
}

enum ts_status ts_voxel_self_affine(const struct ts_voxel_self_affine *s, double *height)
{
	size_t n = (size_t)s->n[0] * (size_t)s->n[1];
	double waves = variance(s);
	struct filter filter = { s, waves > 0 ? 1 / sqrt(waves) : 0 };
	struct ts_convolution c;
	enum ts_status status;

	if (!(waves > 0))
		return TS_RANGE;
	TS_TRY(ts_voxel_noise(s->noise, s->seed, s->n, height));
	status = ts_convolution_make(&c, s->n, true, 1);
	if (status == TS_OK) {
		ts_convolution_set_spectrum(&c, amplitude, &filter);
		status = ts_convolution_apply(&c, height, height);
	}
	ts_convolution_release(&c);
	if (status == TS_OK && s->exact)
		ts_voxel_normalise(height, n);
	for (size_t k = 0; k < n; k++)
		height[k] = s->mean + s->deviation * height[k];
	return status;
}
