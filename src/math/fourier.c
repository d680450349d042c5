#include "math/fourier.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/alloc.h"
#include "base/clones.h"

#include "base/banned.h"

static const double TWO_PI = 6.283185307179586476925286766559;

void ts_fourier_root(long k, long n, double root[2])
{
	long quarter;
	double a, c, s;

	/* the angle minus a multiple of 90 degrees, at most 45 degrees */
	k = ((k % n) + n) % n;
	quarter = (8 * k / n + 1) / 2;
	a = TWO_PI * (double)(4 * k - quarter * n) / (double)(4 * n);
	c = cos(a);
	s = sin(a);
	root[0] = quarter % 2 ? (quarter == 1 ? -s : s) : quarter == 2 ? -c : c;
	root[1] = quarter % 2 ? (quarter == 1 ? c : -c) : quarter == 2 ? -s : s;
}

enum { LARGE = 13 }; /* for larger primes a convolution is faster than direct sums */

static int smallest_radix(int n)
{
	static const int good[] = { 4, 2, 3, 5 };

	for (size_t k = 0; k < sizeof good / sizeof *good; k++)
		if (n % good[k] == 0)
			return good[k];
	for (int p = 7; p <= n / p; p += 2)
		if (n % p == 0)
			return p;
	return n;
}

static bool has_small_factors(int n, int largest)
{
	for (; n > 1; n /= smallest_radix(n))
		if (smallest_radix(n) > largest)
			return false;
	return true;
}

static enum ts_status make_chirp(struct ts_fourier *f)
{
	int n = f->n, m = 2 * n - 1;
	double *re, *im, *spare;

	while (!has_small_factors(m, 3))
		m++;
	f->longer = ts_alloc(1, sizeof *f->longer);
	f->chirp = ts_alloc((size_t)n, sizeof *f->chirp);
	f->filter = ts_alloc((size_t)m, sizeof *f->filter);
	if (!f->longer || !f->chirp || !f->filter || ts_fourier_make(f->longer, m) != TS_OK)
		return TS_NOMEM;
	re = ts_alloc(2 * (size_t)m + ts_fourier_work_size(f->longer, 1), sizeof *re);
	if (!re)
		return TS_NOMEM;
	im = re + m;
	spare = im + m;
	for (long k = 0; k < n; k++) {
		ts_fourier_root(k * k % (2 * n), 2 * n, f->chirp[k]);
		re[k] = re[k ? m - k : 0] = f->chirp[k][0];
		im[k] = im[k ? m - k : 0] = f->chirp[k][1];
	}
	ts_fourier_apply(f->longer, 1, re, im, spare);
	for (int k = 0; k < m; k++) {
		f->filter[k][0] = re[k] / m;
		f->filter[k][1] = im[k] / m;
	}
	ts_free(re);
	return TS_OK;
}

enum ts_status ts_fourier_make(struct ts_fourier *f, int n)
{
	*f = (struct ts_fourier){ .n = n };
	if (!has_small_factors(n, LARGE))
		return make_chirp(f);
	for (int length = n; length > 1; length /= f->radix[f->stages++])
		f->radix[f->stages] = smallest_radix(length);
	f->root = ts_alloc((size_t)n, sizeof *f->root);
	if (!f->root)
		return TS_NOMEM;
	for (int k = 0; k < n; k++)
		ts_fourier_root(k, n, f->root[k]);
	return TS_OK;
}

void ts_fourier_release(struct ts_fourier *f)
{
	if (f->longer)
		ts_fourier_release(f->longer);
	ts_free(f->longer);
	ts_free(f->chirp);
	ts_free(f->filter);
	ts_free(f->root);
	*f = (struct ts_fourier){ 0 };
}

size_t ts_fourier_work_size(const struct ts_fourier *f, int lines)
{
	size_t rows = f->longer ? 4 * (size_t)f->longer->n : 2 * (size_t)f->n;

	return rows * (size_t)lines;
}

/* A stage of a transform: `rest` butterflies, each for `block` adjacent numbers. */
struct pass {
	const double *xr, *xi;
	double *yr, *yi;
	double (*root)[2];
	size_t block;
	int radix, rest, apart; /* apart: distance between the roots that the stage uses */
};

/* The k-th term of butterfly p, and its k-th result. */
#define TERM(x, k) ((x) + (size_t)(p + (k)*s->rest) * s->block)
#define RESULT(y, k) ((y) + (size_t)(p * s->radix + (k)) * s->block)
#define TURN(k, part) (s->root[p * (k)*s->apart][part])

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

TS_CLONES
static void radix5(const struct pass *s)
{
	/* cos and sin of 72 and 144 degrees */
	const double ca = 0.30901699437494742410229341718282, cb = -0.80901699437494742410229341718282;
	const double sa = 0.95105651629515357211643933337938, sb = 0.58778525229247312916870595463907;
	const size_t n = s->block;

	for (int p = 0; p < s->rest; p++) {
		const double *restrict xr = TERM(s->xr, 0), *restrict xi = TERM(s->xi, 0);
		double *restrict yr = RESULT(s->yr, 0), *restrict yi = RESULT(s->yi, 0);
		const double c1 = TURN(1, 0), s1 = TURN(1, 1), c2 = TURN(2, 0), s2 = TURN(2, 1);
		const double c3 = TURN(3, 0), s3 = TURN(3, 1), c4 = TURN(4, 0), s4 = TURN(4, 1);
		const size_t in = (size_t)s->rest * n;

#pragma omp simd
		for (size_t l = 0; l < n; l++) {
			double r0 = xr[l], i0 = xi[l];
			double ar = xr[l + in] + xr[l + 4 * in], ai = xi[l + in] + xi[l + 4 * in];
			double br = xr[l + 2 * in] + xr[l + 3 * in], bi = xi[l + 2 * in] + xi[l + 3 * in];
			double cr = xr[l + in] - xr[l + 4 * in], ci = xi[l + in] - xi[l + 4 * in];
			double dr = xr[l + 2 * in] - xr[l + 3 * in], di = xi[l + 2 * in] - xi[l + 3 * in];
			double er = r0 + (ca * ar + cb * br), ei = i0 + (ca * ai + cb * bi);
			double fr = r0 + (cb * ar + ca * br), fi = i0 + (cb * ai + ca * bi);
			double gr = sa * ci + sb * di, gi = -(sa * cr + sb * dr);
			double hr = sb * ci - sa * di, hi = -(sb * cr - sa * dr);
			double ur = er + gr, ui = ei + gi, vr = fr + hr, vi = fi + hi;
			double wr = fr - hr, wi = fi - hi, zr = er - gr, zi = ei - gi;

			yr[l] = r0 + (ar + br);
			yi[l] = i0 + (ai + bi);
			yr[l + n] = c1 * ur + s1 * ui;
			yi[l + n] = c1 * ui - s1 * ur;
			yr[l + 2 * n] = c2 * vr + s2 * vi;
			yi[l + 2 * n] = c2 * vi - s2 * vr;
			yr[l + 3 * n] = c3 * wr + s3 * wi;
			yi[l + 3 * n] = c3 * wi - s3 * wr;
			yr[l + 4 * n] = c4 * zr + s4 * zi;
			yi[l + 4 * n] = c4 * zi - s4 * zr;
		}
	}
}

/* y_k += x (cos, -sin) of the angle given. */
TS_CLONES
static void add_rotated(const double *restrict xr, const double *restrict xi, const double root[2],
			double *restrict yr, double *restrict yi, size_t n)
{
	const double c = root[0], s = root[1];

#pragma omp simd
	for (size_t l = 0; l < n; l++) {
		yr[l] += c * xr[l] + s * xi[l];
		yi[l] += c * xi[l] - s * xr[l];
	}
}

/* Any radix, by direct sums. */
static void radix_general(const struct ts_fourier *f, const struct pass *s)
{
	int step = f->n / s->radix; /* between roots of the radix */

	for (int p = 0; p < s->rest; p++)
		for (int k = 0; k < s->radix; k++) {
			double *yr = RESULT(s->yr, k), *yi = RESULT(s->yi, k);

			memset(yr, 0, s->block * sizeof *yr);
			memset(yi, 0, s->block * sizeof *yi);
			for (int j = 0; j < s->radix; j++) {
				long turn = (long)step * ((long)j * k % s->radix) + (long)p * k * s->apart;

				add_rotated(TERM(s->xr, j), TERM(s->xi, j), f->root[turn % f->n], yr, yi,
					    s->block);
			}
		}
}

static void make_pass(const struct ts_fourier *f, const struct pass *s)
{
	switch (s->radix) {
	case 2:
		radix2(s);
		break;
	case 3:
		radix3(s);
		break;
	case 4:
		radix4(s);
		break;
	case 5:
		radix5(s);
		break;
	default:
		radix_general(f, s);
	}
}

/* out = x times the conjugate of f in rows of `lines`. */
TS_CLONES
static void rotate_rows(const double (*f)[2], int rows, int lines, const double *xr, const double *xi,
			double *yr, double *yi)
{
	for (int k = 0; k < rows; k++) {
		const double c = f[k][0], s = f[k][1];

#pragma omp simd
		for (int l = k * lines; l < (k + 1) * lines; l++) {
			double r = xr[l], i = xi[l];

			yr[l] = c * r + s * i;
			yi[l] = c * i - s * r;
		}
	}
}

/* Bluestein's algorithm: multiply by the chirp, convolve with its conjugate, multiply again. */
static void convolve(const struct ts_fourier *f, int lines, double *re, double *im, double *spare)
{
	const struct ts_fourier *g = f->longer;
	size_t part = (size_t)g->n * (size_t)lines, used = (size_t)f->n * (size_t)lines;
	double *ar = spare, *ai = ar + part, *rest = ai + part;

	rotate_rows((const double(*)[2])f->chirp, f->n, lines, re, im, ar, ai);
	memset(ar + used, 0, (part - used) * sizeof *ar);
	memset(ai + used, 0, (part - used) * sizeof *ai);
	ts_fourier_apply(g, lines, ar, ai, rest);
	/* times the filter, with re and im exchanged: (i a) conj(f), so the inverse has them exchanged too */
	rotate_rows((const double(*)[2])f->filter, g->n, lines, ai, ar, ai, ar);
	ts_fourier_apply(g, lines, ai, ar, rest);
	rotate_rows((const double(*)[2])f->chirp, f->n, lines, ar, ai, re, im);
}

void ts_fourier_apply(const struct ts_fourier *f, int lines, double *re, double *im, double *spare)
{
	double *spare_re = spare, *spare_im = spare + (size_t)f->n * (size_t)lines;
	struct pass s = { .xr = re, .xi = im, .yr = spare_re, .yi = spare_im };
	size_t bytes = (size_t)f->n * (size_t)lines * sizeof *re;

	if (f->longer) {
		convolve(f, lines, re, im, spare);
		return;
	}
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
