#include "flow/fourier.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/clones.h"

#include "base/banned.h"

static const double TWO_PI = 6.283185307179586476925286766559;

void ts_fourier_root(long k, long n, double root[2])
{
	long quarter;
	double a, c, s;

	/* the angle less a multiple of 90 degrees: at most 45 */
	k = ((k % n) + n) % n;
	quarter = (8 * k / n + 1) / 2;
	a = TWO_PI * (double)(4 * k - quarter * n) / (double)(4 * n);
	c = cos(a);
	s = sin(a);
	root[0] = quarter % 2 ? (quarter == 1 ? -s : s) : quarter == 2 ? -c : c;
	root[1] = quarter % 2 ? (quarter == 1 ? c : -c) : quarter == 2 ? -s : s;
}

static int next_radix(int n)
{
	static const int good[] = { 4, 2, 3 };

	for (size_t k = 0; k < sizeof good / sizeof *good; k++)
		if (n % good[k] == 0)
			return good[k];
	for (int p = 5; p * p <= n; p += 2)
		if (n % p == 0)
			return p;
	return n;
}

enum ts_status ts_fourier_make(struct ts_fourier *f, int n)
{
	*f = (struct ts_fourier){ .n = n };
	for (int length = n; length > 1; length /= f->radix[f->stages++])
		f->radix[f->stages] = next_radix(length);
	f->root = ts_alloc((size_t)n, sizeof *f->root);
	if (!f->root)
		return TS_NOMEM;
	for (int k = 0; k < n; k++)
		ts_fourier_root(k, n, f->root[k]);
	return TS_OK;
}

void ts_fourier_release(struct ts_fourier *f)
{
	ts_free(f->root);
	f->root = NULL;
}

/* A stage of a transform: `rest` butterflies, each for `block` numbers side by side. */
struct pass {
	const double *xr, *xi;
	double *yr, *yi;
	double (*root)[2];
	size_t block;
	int radix, rest, apart; /* apart: between roots that the stage uses */
};

/* The k-th term of butterfly p, and its k-th result. */
#define TERM(x, k) ((x) + (size_t)(p + (k) * s->rest) * s->block)
#define RESULT(y, k) ((y) + (size_t)(p * s->radix + (k)) * s->block)
#define TURN(k, part) (s->root[p * (k) * s->apart][part])

TS_CLONES
static void radix2(const struct pass *s)
{
	const size_t n = s->block;

	for (int p = 0; p < s->rest; p++) {
		const double *restrict r0 = TERM(s->xr, 0), *restrict r1 = TERM(s->xr, 1);
		const double *restrict i0 = TERM(s->xi, 0), *restrict i1 = TERM(s->xi, 1);
		double *restrict y0 = RESULT(s->yr, 0), *restrict y1 = RESULT(s->yr, 1);
		double *restrict z0 = RESULT(s->yi, 0), *restrict z1 = RESULT(s->yi, 1);
		const double c1 = TURN(1, 0), s1 = TURN(1, 1);

#pragma omp simd
		for (size_t l = 0; l < n; l++) {
			double ar = r0[l] - r1[l], ai = i0[l] - i1[l];

			y0[l] = r0[l] + r1[l];
			z0[l] = i0[l] + i1[l];
			y1[l] = c1 * ar + s1 * ai;
			z1[l] = c1 * ai - s1 * ar;
		}
	}
}

TS_CLONES
static void radix3(const struct pass *s)
{
	const double half = 0.86602540378443864676372317075294; /* sin 60 degrees */
	const size_t n = s->block;

	for (int p = 0; p < s->rest; p++) {
		const double *restrict r0 = TERM(s->xr, 0), *restrict r1 = TERM(s->xr, 1);
		const double *restrict r2 = TERM(s->xr, 2), *restrict i0 = TERM(s->xi, 0);
		const double *restrict i1 = TERM(s->xi, 1), *restrict i2 = TERM(s->xi, 2);
		double *restrict y0 = RESULT(s->yr, 0), *restrict y1 = RESULT(s->yr, 1);
		double *restrict y2 = RESULT(s->yr, 2), *restrict z0 = RESULT(s->yi, 0);
		double *restrict z1 = RESULT(s->yi, 1), *restrict z2 = RESULT(s->yi, 2);
		const double c1 = TURN(1, 0), s1 = TURN(1, 1), c2 = TURN(2, 0), s2 = TURN(2, 1);

#pragma omp simd
		for (size_t l = 0; l < n; l++) {
			double sr = r1[l] + r2[l], si = i1[l] + i2[l];
			double dr = half * (i1[l] - i2[l]), di = half * (r2[l] - r1[l]);
			double mr = r0[l] - 0.5 * sr, mi = i0[l] - 0.5 * si;
			double ar = mr + dr, ai = mi + di, br = mr - dr, bi = mi - di;

			y0[l] = r0[l] + sr;
			z0[l] = i0[l] + si;
			y1[l] = c1 * ar + s1 * ai;
			z1[l] = c1 * ai - s1 * ar;
			y2[l] = c2 * br + s2 * bi;
			z2[l] = c2 * bi - s2 * br;
		}
	}
}

TS_CLONES
static void radix4(const struct pass *s)
{
	const size_t n = s->block;

	for (int p = 0; p < s->rest; p++) {
		const double *restrict r0 = TERM(s->xr, 0), *restrict r1 = TERM(s->xr, 1);
		const double *restrict r2 = TERM(s->xr, 2), *restrict r3 = TERM(s->xr, 3);
		const double *restrict i0 = TERM(s->xi, 0), *restrict i1 = TERM(s->xi, 1);
		const double *restrict i2 = TERM(s->xi, 2), *restrict i3 = TERM(s->xi, 3);
		double *restrict y0 = RESULT(s->yr, 0), *restrict y1 = RESULT(s->yr, 1);
		double *restrict y2 = RESULT(s->yr, 2), *restrict y3 = RESULT(s->yr, 3);
		double *restrict z0 = RESULT(s->yi, 0), *restrict z1 = RESULT(s->yi, 1);
		double *restrict z2 = RESULT(s->yi, 2), *restrict z3 = RESULT(s->yi, 3);
		const double c1 = TURN(1, 0), s1 = TURN(1, 1), c2 = TURN(2, 0), s2 = TURN(2, 1);
		const double c3 = TURN(3, 0), s3 = TURN(3, 1);

#pragma omp simd
		for (size_t l = 0; l < n; l++) {
			double ar = r0[l] + r2[l], ai = i0[l] + i2[l];
			double br = r0[l] - r2[l], bi = i0[l] - i2[l];
			double cr = r1[l] + r3[l], ci = i1[l] + i3[l];
			double dr = i1[l] - i3[l], di = r3[l] - r1[l];
			double er = br + dr, ei = bi + di, fr = ar - cr, fi = ai - ci;
			double gr = br - dr, gi = bi - di;

			y0[l] = ar + cr;
			z0[l] = ai + ci;
			y1[l] = c1 * er + s1 * ei;
			z1[l] = c1 * ei - s1 * er;
			y2[l] = c2 * fr + s2 * fi;
			z2[l] = c2 * fi - s2 * fr;
			y3[l] = c3 * gr + s3 * gi;
			z3[l] = c3 * gi - s3 * gr;
		}
	}
}

/* y_k += x (cos, -sin) of the angle given. */
TS_CLONES
static void add_turned(const double *restrict xr, const double *restrict xi, const double root[2],
		       double *restrict yr, double *restrict yi, size_t n)
{
	const double c = root[0], s = root[1];

#pragma omp simd
	for (size_t l = 0; l < n; l++) {
		yr[l] += c * xr[l] + s * xi[l];
		yi[l] += c * xi[l] - s * xr[l];
	}
}

/* Any radix, by the sums themselves. */
static void radix_any(const struct ts_fourier *f, const struct pass *s)
{
	int step = f->n / s->radix; /* between roots of the radix */

	for (int p = 0; p < s->rest; p++)
		for (int k = 0; k < s->radix; k++) {
			double *yr = RESULT(s->yr, k), *yi = RESULT(s->yi, k);

			memset(yr, 0, s->block * sizeof *yr);
			memset(yi, 0, s->block * sizeof *yi);
			for (int j = 0; j < s->radix; j++) {
				long turn = (long)step * ((long)j * k % s->radix) +
					    (long)p * k * s->apart;

				add_turned(TERM(s->xr, j), TERM(s->xi, j), f->root[turn % f->n], yr,
					   yi, s->block);
			}
		}
}

static void make_pass(const struct ts_fourier *f, const struct pass *s)
{
	switch (s->radix) {
	case 2: radix2(s); break;
	case 3: radix3(s); break;
	case 4: radix4(s); break;
	default: radix_any(f, s);
	}
}

void ts_fourier_apply(const struct ts_fourier *f, int lines, double *re, double *im, double *spare_re,
		      double *spare_im)
{
	struct pass s = { .xr = re, .xi = im, .yr = spare_re, .yi = spare_im };
	size_t bytes = (size_t)f->n * (size_t)lines * sizeof *re;

	s.root = f->root;
	for (int k = 0, length = f->n; k < f->stages; length /= f->radix[k++]) {
		s.radix = f->radix[k];
		s.rest = length / s.radix;
		s.apart = f->n / length;
		s.block = (size_t)s.apart * (size_t)lines;
		make_pass(f, &s);
		s.xr = s.yr;
		s.xi = s.yi;
		s.yr = s.yr == re ? spare_re : re;
		s.yi = s.yi == im ? spare_im : im;
	}
	if (s.xr != re) {
		memcpy(re, s.xr, bytes);
		memcpy(im, s.xi, bytes);
	}
}
