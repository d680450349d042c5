#include "math/convolution.h"

#include <string.h>

#include "base/alloc.h"
#include "base/parallel.h"

#include "base/banned.h"

enum {
	LINES = 16 /* transformed at once; a block of 16 lines of 1000 complex numbers has 256 kB */,
	TILE = 8
};

/* Smallest number >= n whose factors are 2, 3 and 5. */
static int smooth_length(int n)
{
	for (;; n++) {
		int rest = n;

		for (int p = 2; p <= 5; p++)
			while (rest % p == 0)
				rest /= p;
		if (rest == 1)
			return n;
	}
}

enum ts_status ts_convolution_make(struct ts_convolution *c, const int n[2], bool periodic, int threads)
{
	*c = (struct ts_convolution){ .threads = threads };
	for (int d = 0; d < 2; d++) {
		c->n[d] = n[d];
		c->length[d] = periodic ? n[d] : smooth_length(2 * n[d] - 1);
	}
	c->modes = c->length[1] / 2 + 1;
	c->pairs = (n[0] + 1) / 2;
	for (int d = 0; d < 2; d++)
		TS_TRY(ts_fourier_make(&c->fourier[d], c->length[d]));
	c->spectrum = ts_alloc((size_t)c->modes * (size_t)c->length[0], sizeof *c->spectrum);
	c->re = ts_alloc((size_t)c->modes * (size_t)n[0], sizeof *c->re);
	c->im = ts_alloc((size_t)c->modes * (size_t)n[0], sizeof *c->im);
	return c->spectrum && c->re && c->im ? TS_OK : TS_NOMEM;
}

void ts_convolution_release(struct ts_convolution *c)
{
	for (int d = 0; d < 2; d++)
		ts_fourier_release(&c->fourier[d]);
	ts_free(c->spectrum);
	ts_free(c->re);
	ts_free(c->im);
	*c = (struct ts_convolution){ 0 };
}

/* ---- blocks of lines ---- */

/* A transform of one axis for all lines, by blocks of LINES. The functions of ranges of blocks return the number of
 * failed allocations. */
struct job {
	struct ts_convolution *c;
	const double *in;
	double *out;
};

/* Work memory of a block: re, im, and what the transform needs. */
struct block {
	double *re, *im, *spare;
};

static bool make_block(const struct ts_fourier *f, struct block *b)
{
	size_t n = (size_t)f->n * LINES;

	b->re = ts_alloc_aligned(2 * n + ts_fourier_work_size(f, LINES), sizeof *b->re);
	b->im = b->re + n;
	b->spare = b->im + n;
	return b->re != NULL;
}

static int least(int a, int b)
{
	return a < b ? a : b;
}

static size_t blocks(int lines)
{
	return ((size_t)lines + LINES - 1) / LINES;
}

/* ---- along the second axis: column p is the real part, column pairs + p the imaginary part ---- */

static void load_columns(const struct ts_convolution *c, const double *in, int first, struct block *b)
{
	size_t n0 = (size_t)c->n[0];
	int here = least(LINES, c->pairs - first), there = least(LINES, c->n[0] - c->pairs - first);

	memset(b->re, 0, (size_t)c->length[1] * LINES * sizeof *b->re);
	memset(b->im, 0, (size_t)c->length[1] * LINES * sizeof *b->im);
	for (int j = 0; j < c->n[1]; j++) {
		const double *row = in + (size_t)j * n0 + first;

		for (int l = 0; l < here; l++)
			b->re[j * LINES + l] = row[l];
		for (int l = 0; l < there; l++)
			b->im[j * LINES + l] = row[c->pairs + l];
	}
}

/* Separates the transforms of the two columns: X = (Z_k + Z*_-k)/2, Y = (Z_k - Z*_-k)/2i. */
static void store_modes(struct ts_convolution *c, const struct block *b, int first)
{
	int here = least(LINES, c->pairs - first), there = least(LINES, c->n[0] - c->pairs - first);

	for (int k = 0; k < c->modes; k++) {
		const double *zr = b->re + k * LINES, *zi = b->im + k * LINES;
		const double *mr = b->re + (c->length[1] - k) % c->length[1] * LINES;
		const double *mi = b->im + (c->length[1] - k) % c->length[1] * LINES;
		double *re = c->re + (size_t)k * (size_t)c->n[0] + first;
		double *im = c->im + (size_t)k * (size_t)c->n[0] + first;

		for (int l = 0; l < here; l++) {
			re[l] = 0.5 * (zr[l] + mr[l]);
			im[l] = 0.5 * (zi[l] - mi[l]);
		}
		for (int l = 0; l < there; l++) {
			re[c->pairs + l] = 0.5 * (zi[l] + mi[l]);
			im[c->pairs + l] = 0.5 * (mr[l] - zr[l]);
		}
	}
}

static long transform_columns(void *context, size_t from, size_t to)
{
	struct job *job = context;
	struct block b;

	if (!make_block(&job->c->fourier[1], &b))
		return 1;
	for (size_t k = from; k < to; k++) {
		load_columns(job->c, job->in, (int)k * LINES, &b);
		ts_fourier_apply(&job->c->fourier[1], LINES, b.re, b.im, b.spare);
		store_modes(job->c, &b, (int)k * LINES);
	}
	ts_free(b.re);
	return 0;
}

/* Z = X + iY from the halves of their modes; the reverse of store_modes. */
static void load_modes(const struct ts_convolution *c, int first, struct block *b)
{
	int here = least(LINES, c->pairs - first), there = least(LINES, c->n[0] - c->pairs - first);

	for (int k = 0; k < c->length[1]; k++) {
		bool mirrored = k >= c->modes;
		double sign = mirrored ? -1 : 1;
		size_t at = (size_t)(mirrored ? c->length[1] - k : k) * (size_t)c->n[0] + (size_t)first;
		const double *xr = c->re + at, *xi = c->im + at, *yr = xr + c->pairs, *yi = xi + c->pairs;
		double *zr = b->re + k * LINES, *zi = b->im + k * LINES;

		for (int l = 0; l < there; l++) {
			zr[l] = xr[l] - sign * yi[l];
			zi[l] = sign * xi[l] + yr[l];
		}
		for (int l = there > 0 ? there : 0; l < here;
		     l++) { /* of an odd number of columns the last */
			zr[l] = xr[l];
			zi[l] = sign * xi[l];
		}
		for (int l = here; l < LINES; l++)
			zr[l] = zi[l] = 0;
	}
}

static void store_columns(const struct ts_convolution *c, const struct block *b, int first, double *out)
{
	int here = least(LINES, c->pairs - first), there = least(LINES, c->n[0] - c->pairs - first);

	for (int j = 0; j < c->n[1]; j++) {
		double *row = out + (size_t)j * (size_t)c->n[0] + first;

		for (int l = 0; l < here; l++)
			row[l] = b->re[j * LINES + l];
		for (int l = 0; l < there; l++)
			row[c->pairs + l] = b->im[j * LINES + l];
	}
}

static long invert_columns(void *context, size_t from, size_t to)
{
	struct job *job = context;
	struct block b;

	if (!make_block(&job->c->fourier[1], &b))
		return 1;
	for (size_t k = from; k < to; k++) {
		load_modes(job->c, (int)k * LINES, &b);
		ts_fourier_apply(&job->c->fourier[1], LINES, b.im, b.re, b.spare); /* inverse */
		store_columns(job->c, &b, (int)k * LINES, job->out);
	}
	ts_free(b.re);
	return 0;
}

/* ---- along the first axis ---- */

/* Transposed by tiles of TILE columns, a cache line of each row. */
static void load_rows(const struct ts_convolution *c, int first, struct block *b)
{
	int lines = least(LINES, c->modes - first);

	memset(b->re, 0, (size_t)c->length[0] * LINES * sizeof *b->re);
	memset(b->im, 0, (size_t)c->length[0] * LINES * sizeof *b->im);
	for (int from = 0; from < c->n[0]; from += TILE)
		for (int l = 0; l < lines; l++) {
			const double *re = c->re + (size_t)(first + l) * (size_t)c->n[0];
			const double *im = c->im + (size_t)(first + l) * (size_t)c->n[0];

			for (int i = from; i < least(from + TILE, c->n[0]); i++) {
				b->re[i * LINES + l] = re[i];
				b->im[i * LINES + l] = im[i];
			}
		}
}

static void store_rows(struct ts_convolution *c, const struct block *b, int first)
{
	int lines = least(LINES, c->modes - first);

	for (int from = 0; from < c->n[0]; from += TILE)
		for (int l = 0; l < lines; l++) {
			double *re = c->re + (size_t)(first + l) * (size_t)c->n[0];
			double *im = c->im + (size_t)(first + l) * (size_t)c->n[0];

			for (int i = from; i < least(from + TILE, c->n[0]); i++) {
				re[i] = b->re[i * LINES + l];
				im[i] = b->im[i * LINES + l];
			}
		}
}

static void multiply(const struct ts_convolution *c, int first, struct block *b)
{
	int lines = least(LINES, c->modes - first);

	for (int from = 0; from < c->length[0]; from += TILE)
		for (int l = 0; l < lines; l++) {
			const double *spectrum = c->spectrum + (size_t)(first + l) * (size_t)c->length[0];

			for (int i = from; i < least(from + TILE, c->length[0]); i++) {
				b->re[i * LINES + l] *= spectrum[i];
				b->im[i * LINES + l] *= spectrum[i];
			}
		}
}

static long convolve_rows(void *context, size_t from, size_t to)
{
	struct job *job = context;
	struct ts_convolution *c = job->c;
	struct block b;

	if (!make_block(&c->fourier[0], &b))
		return 1;
	for (size_t k = from; k < to; k++) {
		load_rows(c, (int)k * LINES, &b);
		ts_fourier_apply(&c->fourier[0], LINES, b.re, b.im, b.spare);
		multiply(c, (int)k * LINES, &b);
		ts_fourier_apply(&c->fourier[0], LINES, b.im, b.re, b.spare); /* inverse */
		store_rows(c, &b, (int)k * LINES);
	}
	ts_free(b.re);
	return 0;
}

enum ts_status ts_convolution_apply(struct ts_convolution *c, const double *in, double *out)
{
	struct job job = { .c = c, .in = in, .out = out };

	if (ts_parallel_count(c->threads, blocks(c->pairs), transform_columns, &job) ||
	    ts_parallel_count(c->threads, blocks(c->modes), convolve_rows, &job) ||
	    ts_parallel_count(c->threads, blocks(c->pairs), invert_columns, &job))
		return TS_NOMEM;
	return TS_OK;
}

/* ---- the kernel ---- */

void ts_convolution_set_spectrum(struct ts_convolution *c, ts_kernel_fn *spectrum, const void *context)
{
	double points = (double)c->length[0] * (double)c->length[1];
	int length = c->length[0];

	for (int l = 0; l < c->modes; l++) {
		double *row = c->spectrum + (size_t)l * (size_t)length;

		for (int k = 0; k <= length / 2; k++)
			row[k] = row[(length - k) % length] = spectrum(context, k, l) / points;
	}
}

/* The transform of an even function along one axis is real: the cosine sums of all lines, [n][lines]. */
static enum ts_status transform_even(const struct ts_fourier *f, int lines, double *re)
{
	size_t n = (size_t)f->n * (size_t)lines;
	double *im = ts_alloc(n + ts_fourier_work_size(f, lines), sizeof *im);

	if (!im)
		return TS_NOMEM;
	ts_fourier_apply(f, lines, re, im, im + n);
	ts_free(im);
	return TS_OK;
}

/* The kernel is even: a quarter of its values, and their mirror images. */
static void fill_even(const struct ts_convolution *c, ts_kernel_fn *kernel, const void *context,
		      double *value)
{
	size_t m0 = (size_t)c->length[0], m1 = (size_t)c->length[1];

	for (size_t j = 0; j <= m1 / 2; j++) {
		double *row = value + j * m0;

		for (size_t i = 0; i <= m0 / 2; i++)
			row[i] = row[(m0 - i) % m0] = kernel(context, (int)i, (int)j);
		if (j < m1 - j && j)
			memcpy(value + (m1 - j) * m0, row, m0 * sizeof *row);
	}
}

enum ts_status ts_convolution_set_kernel(struct ts_convolution *c, ts_kernel_fn *kernel, const void *context)
{
	size_t m0 = (size_t)c->length[0], m1 = (size_t)c->length[1];
	double *across = ts_alloc(m0 * m1, sizeof *across), *along = ts_alloc(m0 * m1, sizeof *along);
	enum ts_status status = across && along ? TS_OK : TS_NOMEM;

	if (status == TS_OK)
		fill_even(c, kernel, context, across);
	if (status == TS_OK)
		status = transform_even(&c->fourier[1], c->length[0], across);
	for (size_t j = 0; j < m1 && status == TS_OK; j++)
		for (size_t i = 0; i < m0; i++)
			along[i * m1 + j] = across[j * m0 + i];
	if (status == TS_OK)
		status = transform_even(&c->fourier[0], c->length[1], along);
	for (size_t l = 0; l < (size_t)c->modes && status == TS_OK; l++)
		for (size_t k = 0; k < m0; k++)
			c->spectrum[l * m0 + k] = along[k * m1 + l] / ((double)m0 * (double)m1);
	ts_free(across);
	ts_free(along);
	return status;
}
