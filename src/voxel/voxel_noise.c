#include "voxel/voxel_noise.h"

#include <math.h>
#include <stdbool.h>

#include "base/alloc.h"
#include "math/fourier.h"
#include "math/rng.h"

#include "base/banned.h"

static void fill_columns(uint64_t seed, size_t n, double *noise)
{
	for (size_t k = 0; k < n; k++) {
		struct ts_rng rng = ts_rng_start(seed, k);

		noise[k] = ts_rng_normal(&rng);
	}
}

/* Amplitudes of the waves [n[1]][n[0]], and memory for their transforms. */
struct waves {
	int n[2];
	size_t cells;
	double *re, *im, *other_re, *other_im, *spare;
	struct ts_fourier fourier[2];
};

static enum ts_status make_waves(struct waves *w, const int n[2])
{
	size_t most = 0;

	w->cells = (size_t)n[0] * (size_t)n[1];
	for (int d = 0; d < 2; d++) {
		size_t work;

		w->n[d] = n[d];
		TS_TRY(ts_fourier_make(&w->fourier[d], n[d]));
		work = ts_fourier_work_size(&w->fourier[d], n[1 - d]);
		most = most > work ? most : work;
	}
	w->re = ts_alloc(4 * w->cells + most, sizeof *w->re);
	w->im = w->re + w->cells;
	w->other_re = w->im + w->cells;
	w->other_im = w->other_re + w->cells;
	w->spare = w->other_im + w->cells;
	return w->re ? TS_OK : TS_NOMEM;
}

static void release(struct waves *w)
{
	for (int d = 0; d < 2; d++)
		ts_fourier_release(&w->fourier[d]);
	ts_free(w->re);
}

/* The wave numbers -n/2 < k <= n/2 of an index. */
static int wave_number(int index, int n)
{
	return index <= n / 2 ? index : index - n;
}

/* A wave of number k, l and that of -k, -l, its complex conjugate, as the sum is real; the phase is that at the centre
 * of the first column. */
static void draw_wave(struct waves *w, uint64_t seed, int i, int j)
{
	int k = wave_number(i, w->n[0]), l = wave_number(j, w->n[1]);
	size_t n0 = (size_t)w->n[0], at = (size_t)j * n0 + (size_t)i;
	size_t mirror = (size_t)((w->n[1] - j) % w->n[1]) * n0 + (size_t)((w->n[0] - i) % w->n[0]);
	struct ts_rng rng = ts_rng_start(seed, (uint64_t)(uint32_t)k << 32 | (uint32_t)l);
	double a = ts_rng_normal(&rng), b = ts_rng_normal(&rng), x[2], y[2], c, s;

	if (at == mirror) { /* the mean; waves of two columns */
		w->re[at] = a;
		return;
	}
	ts_fourier_root(k, 2L * w->n[0], x);
	ts_fourier_root(l, 2L * w->n[1], y);
	c = (x[0] * y[0] - x[1] * y[1]) / sqrt(2);
	s = (x[0] * y[1] + x[1] * y[0]) / sqrt(2);
	w->re[at] = w->re[mirror] = a * c - b * s;
	w->im[at] = a * s + b * c;
	w->im[mirror] = -w->im[at];
}

static void transpose(int n0, int n1, const double *in, double *out)
{
	for (size_t j = 0; j < (size_t)n1; j++)
		for (size_t i = 0; i < (size_t)n0; i++)
			out[i * (size_t)n1 + j] = in[j * (size_t)n0 + i];
}

static enum ts_status fill_waves(struct waves *w, uint64_t seed, const int n[2], double *noise)
{
	TS_TRY(make_waves(w, n));
	for (int j = 0; j <= n[1] / 2; j++)
		for (int i = 0; i < n[0]; i++)
			if (j || i <= n[0] / 2)
				draw_wave(w, seed, i, j);
	/* inverse transforms */
	ts_fourier_apply(&w->fourier[1], n[0], w->im, w->re, w->spare);
	transpose(n[0], n[1], w->re, w->other_re);
	transpose(n[0], n[1], w->im, w->other_im);
	ts_fourier_apply(&w->fourier[0], n[1], w->other_im, w->other_re, w->spare);
	transpose(n[1], n[0], w->other_re, noise);
	for (size_t k = 0; k < w->cells; k++)
		noise[k] /= sqrt((double)w->cells);
	return TS_OK;
}

enum ts_status ts_voxel_noise(enum ts_voxel_noise_kind kind, uint64_t seed, const int n[2], double *noise)
{
	struct waves w = { .cells = 0 };
	enum ts_status status;

	if (kind == TS_VOXEL_NOISE_COLUMNS) {
		fill_columns(seed, (size_t)n[0] * (size_t)n[1], noise);
		return TS_OK;
	}
	status = fill_waves(&w, seed, n, noise);
	release(&w);
	return status;
}
