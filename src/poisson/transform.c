#include "poisson/transform.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/clones.h"

#include "base/banned.h"

enum { HALF = TS_LINES / 2 };

/* T, symmetrized by the square roots of the widths. */
static void fill_matrix(gsl_matrix *a, const struct ts_poisson *problem, int d)
{
	const double *h = problem->grid->width[d];
	int n = problem->grid->n[d];

	gsl_matrix_set_zero(a);
	for (int i = 0; i <= n; i++) {
		double c = ts_poisson_conductance(problem, d, i);
		bool wraps = problem->condition[d][0] == TS_PRESSURE_PERIODIC;
		int below = i > 0 ? i - 1 : wraps ? n - 1 : -1, above = i < n ? i : wraps ? 0 : -1;

		if (below == above || (wraps && i == n))
			continue;
		if (below >= 0)
			*gsl_matrix_ptr(a, (size_t)below, (size_t)below) -= c / h[below];
		if (above >= 0)
			*gsl_matrix_ptr(a, (size_t)above, (size_t)above) -= c / h[above];
		if (below >= 0 && above >= 0) {
			*gsl_matrix_ptr(a, (size_t)below, (size_t)above) += c / sqrt(h[below] * h[above]);
			*gsl_matrix_ptr(a, (size_t)above, (size_t)below) += c / sqrt(h[below] * h[above]);
		}
	}
}

/* The mode of eigenvalue 0 is known: it is constant. */
static void set_constant(struct ts_transform *t, gsl_vector *values, gsl_matrix *modes, const double *h)
{
	size_t n = (size_t)t->n, least = 0;
	double length = 0;

	for (size_t m = 0; m < n; m++) {
		length += h[m];
		if (fabs(gsl_vector_get(values, m)) < fabs(gsl_vector_get(values, least)))
			least = m;
	}
	gsl_vector_set(values, least, 0);
	for (size_t i = 0; i < n; i++)
		gsl_matrix_set(modes, i, least, sqrt(h[i] / length));
	t->constant = (int)least;
}

static enum ts_status solve_modes(struct ts_transform *t, const struct ts_poisson *problem, int d,
				  gsl_matrix *a, gsl_matrix *modes, gsl_vector *values,
				  gsl_eigen_symmv_workspace *work)
{
	const double *h = problem->grid->width[d];
	size_t n = (size_t)t->n;

	if (!a || !modes || !values || !work)
		return TS_NOMEM;
	fill_matrix(a, problem, d);
	if (gsl_eigen_symmv(a, values, modes, work) != GSL_SUCCESS)
		return TS_PHYSICS;
	if (t->constant >= 0)
		set_constant(t, values, modes, h);
	for (size_t m = 0; m < n; m++) {
		t->eigenvalue[m] = gsl_vector_get(values, m);
		for (size_t i = 0; i < n; i++) {
			t->forward[m * n + i] = gsl_matrix_get(modes, i, m) * sqrt(h[i]);
			t->backward[i * n + m] = gsl_matrix_get(modes, i, m) / sqrt(h[i]);
		}
	}
	return TS_OK;
}

static enum ts_status make_matrix(struct ts_transform *t, const struct ts_poisson *problem, int d)
{
	/* GSL's default handler aborts the process; afterwards the one of the program around the library acts again */
	gsl_error_handler_t *handler = gsl_set_error_handler_off();
	size_t n = (size_t)t->n;
	gsl_matrix *a = gsl_matrix_alloc(n, n), *modes = gsl_matrix_alloc(n, n);
	gsl_vector *values = gsl_vector_alloc(n);
	gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(n);
	enum ts_status status = TS_NOMEM;

	t->forward = ts_alloc_aligned(n * n, sizeof *t->forward);
	t->backward = ts_alloc_aligned(n * n, sizeof *t->backward);
	if (t->forward && t->backward && a && modes && values && work)
		status = solve_modes(t, problem, d, a, modes, values, work);
	gsl_eigen_symmv_free(work);
	gsl_vector_free(values);
	gsl_matrix_free(modes);
	gsl_matrix_free(a);
	gsl_set_error_handler(handler);
	return status;
}

/* -(2/h sin(a/2))^2 with the angle a = 2 pi k/n */
static double wave_eigenvalue(double h, long k, long n)
{
	double root[2];

	ts_fourier_root(k, 2 * n, root);
	return -4 / (h * h) * root[1] * root[1];
}

static enum ts_status make_waves(struct ts_transform *t, double h)
{
	long n = t->n;

	t->turn = ts_alloc((size_t)n, sizeof *t->turn);
	if (!t->turn)
		return TS_NOMEM;
	for (long k = 0; k < n; k++) {
		switch (t->waves) {
		case TS_WAVES_FOURIER:
			t->turn[k][0] = 1;
			t->eigenvalue[k] = wave_eigenvalue(h, k, n);
			break;
		case TS_WAVES_HALF: /* sines in reverse order of cosines */
			ts_fourier_root(k, 4 * n, t->turn[k]);
			t->eigenvalue[k] = wave_eigenvalue(h, t->odd ? n - k : k, 2 * n);
			break;
		default:
			ts_fourier_root(8 * k + 1, 16 * n, t->turn[k]);
			t->eigenvalue[k] = wave_eigenvalue(h, 2 * k + 1, 4 * n);
		}
	}
	return ts_fourier_make(&t->fourier, t->waves == TS_WAVES_QUARTER ? t->n / 2 : t->n);
}

enum ts_status ts_transform_make(struct ts_transform *t, const struct ts_poisson *problem, int d)
{
	const enum ts_pressure_condition *end = problem->condition[d];
	const struct ts_grid *grid = problem->grid;
	bool even = grid->uniform[d];

	*t = (struct ts_transform){ .n = grid->n[d], .constant = -1 };
	t->eigenvalue = ts_alloc((size_t)t->n, sizeof *t->eigenvalue);
	if (!t->eigenvalue)
		return TS_NOMEM;
	if (end[0] != TS_PRESSURE_GIVEN && end[1] != TS_PRESSURE_GIVEN)
		t->constant = 0;
	if (end[0] == TS_PRESSURE_PERIODIC) {
		t->waves = even ? TS_WAVES_FOURIER : TS_WAVES_MATRIX;
	} else if (end[0] == end[1]) {
		t->waves = even ? TS_WAVES_HALF : TS_WAVES_MATRIX;
		t->odd = end[0] == TS_PRESSURE_GIVEN;
	} else {
		t->waves = even && t->n % 2 == 0 ? TS_WAVES_QUARTER : TS_WAVES_MATRIX;
		t->mirrored = end[0] == TS_PRESSURE_GIVEN;
	}
	if (t->waves == TS_WAVES_MATRIX)
		return make_matrix(t, problem, d);
	return make_waves(t, grid->width[d][0]);
}

void ts_transform_release(struct ts_transform *t)
{
	ts_fourier_release(&t->fourier);
	ts_free(t->turn);
	ts_free(t->forward);
	ts_free(t->backward);
	ts_free(t->eigenvalue);
	*t = (struct ts_transform){ 0 };
}

size_t ts_transform_work_size(const struct ts_transform *t)
{
	switch (t->waves) {
	case TS_WAVES_MATRIX:
		return (size_t)t->n * TS_LINES;
	case TS_WAVES_QUARTER: {
		size_t parts = (size_t)t->n * TS_LINES, spare = ts_fourier_work_size(&t->fourier, TS_LINES);

		return parts + (spare > parts ? spare : parts);
	}
	default:
		return (size_t)t->n * TS_LINES + ts_fourier_work_size(&t->fourier, HALF);
	}
}

/* Index of cell i in Makhoul's cosine transform: even cells ascending, then odd cells descending. */
static int makhoul_index(const struct ts_transform *t, int i)
{
	if (t->waves == TS_WAVES_FOURIER)
		return i;
	return i % 2 ? t->n - 1 - i / 2 : i / 2;
}

/* Lines to complex lines, and back. */
TS_CLONES
static void pack_lines(const struct ts_transform *t, const double *lines, double *re, double *im)
{
	for (int i = 0; i < t->n; i++) {
		const double *restrict from = lines + i * TS_LINES, sign = t->odd && i % 2 ? -1 : 1;
		double *restrict r = re + makhoul_index(t, i) * HALF, *restrict s =
									      im + makhoul_index(t, i) * HALF;

#pragma omp simd
		for (int l = 0; l < HALF; l++) {
			r[l] = sign * from[l];
			s[l] = sign * from[l + HALF];
		}
	}
}

TS_CLONES
static void unpack_lines(const struct ts_transform *t, const double *re, const double *im, double *lines)
{
	for (int i = 0; i < t->n; i++) {
		const double *restrict r = re + makhoul_index(t, i) * HALF, *restrict s =
										    im + makhoul_index(t, i) *
												 HALF;
		const double scale = (t->odd && i % 2 ? -1.0 : 1.0) / t->n;
		double *restrict to = lines + i * TS_LINES;

#pragma omp simd
		for (int l = 0; l < HALF; l++) {
			to[l] = scale * r[l];
			to[l + HALF] = scale * s[l];
		}
	}
}

/* Z = V + i W, V and W the spectra of two real lines: V_k = (Z_k + Z*_{n-k})/2, i W_k = (Z_k -
 * Z*_{n-k})/2. Turned by exp(-i a_k), real parts are the amplitudes of modes k, negative imaginary parts
 * those of n - k. */
TS_CLONES
static void separate_spectra(const struct ts_transform *t, const double *re, const double *im, double *lines)
{
	memcpy(lines, re, HALF * sizeof *re);
	memcpy(lines + HALF, im, HALF * sizeof *im);
	for (int k = 1; k <= t->n - k; k++) {
		const double *restrict a = re + k * HALF, *restrict b = im + k * HALF;
		const double *restrict c = re + (t->n - k) * HALF, *restrict d = im + (t->n - k) * HALF;
		double *low = lines + k * TS_LINES, *high = lines + (t->n - k) * TS_LINES;
		const double turn = 0.5 * t->turn[k][0], back = 0.5 * t->turn[k][1];
		double first[TS_LINES], second[TS_LINES];

#pragma omp simd
		for (int l = 0; l < HALF; l++) {
			double vr = a[l] + c[l], vi = b[l] - d[l], wr = b[l] + d[l], wi = c[l] - a[l];

			first[l] = turn * vr + back * vi;
			first[l + HALF] = turn * wr + back * wi;
			second[l] = back * vr - turn * vi;
			second[l + HALF] = back * wr - turn * wi;
		}
		memcpy(high, second, sizeof second);
		memcpy(low, first, sizeof first);
	}
}

TS_CLONES
static void unite_spectra(const struct ts_transform *t, const double *lines, double *re, double *im)
{
	memcpy(re, lines, HALF * sizeof *re);
	memcpy(im, lines + HALF, HALF * sizeof *im);
	for (int k = 1; k < t->n - k; k++) {
		const double *restrict low = lines + k * TS_LINES;
		const double *restrict high = lines + (t->n - k) * TS_LINES;
		double *restrict a = re + k * HALF, *restrict b = im + k * HALF;
		double *restrict c = re + (t->n - k) * HALF, *restrict d = im + (t->n - k) * HALF;
		const double turn = t->turn[k][0], back = t->turn[k][1];

#pragma omp simd
		for (int l = 0; l < HALF; l++) {
			double vr = turn * low[l] + back * high[l];
			double vi = back * low[l] - turn * high[l];
			double wr = turn * low[l + HALF] + back * high[l + HALF];
			double wi = back * low[l + HALF] - turn * high[l + HALF];

			a[l] = vr - wi;
			b[l] = vi + wr;
			c[l] = vr + wi;
			d[l] = wr - vi;
		}
	}
	if (t->n % 2 == 0) {
		int k = t->n / 2;
		double scale = 1 / t->turn[k][0];

#pragma omp simd
		for (int l = 0; l < HALF; l++) {
			re[k * HALF + l] = scale * lines[k * TS_LINES + l];
			im[k * HALF + l] = scale * lines[k * TS_LINES + l + HALF];
		}
	}
}

/* Quarter waves by a transform of half the length, of (x_2m + i x_{n-1-2m}) exp(-i pi (8m+1)/8n); its k-th
 * result, turned in the same way, is (X_2k - i X_{n-1-2k}). Its own inverse, but for 2/n. */
TS_CLONES
static void rotate_quarter_waves(const struct ts_transform *t, const double *x, const double *y, double scale,
				 double *re, double *im)
{
	for (int m = 0; m < t->n / 2; m++) {
		const double cosine = scale * t->turn[m][0], sine = scale * t->turn[m][1];
		const double *restrict a = x + m * TS_LINES, *restrict b = y + m * TS_LINES;
		double *restrict r = re + m * TS_LINES, *restrict s = im + m * TS_LINES;

#pragma omp simd
		for (int l = 0; l < TS_LINES; l++) {
			r[l] = cosine * a[l] + sine * b[l];
			s[l] = cosine * b[l] - sine * a[l];
		}
	}
}

static void transform_quarter_waves(const struct ts_transform *t, double scale, bool from_mirror,
				    bool to_mirror, double *lines, double *spare)
{
	size_t part = (size_t)t->n / 2 * TS_LINES, line = TS_LINES * sizeof *lines;
	double *re = spare, *im = spare + part, *x = spare + 2 * part, *y = spare + 3 * part;
	int last = t->n - 1;

	for (int m = 0; m < t->n / 2; m++) {
		int even = from_mirror ? last - 2 * m : 2 * m;

		memcpy(x + m * TS_LINES, lines + even * TS_LINES, line);
		memcpy(y + m * TS_LINES, lines + (last - even) * TS_LINES, line);
	}
	rotate_quarter_waves(t, x, y, 1, re, im);
	ts_fourier_apply(&t->fourier, TS_LINES, re, im, x);
	rotate_quarter_waves(t, re, im, scale, x, y);
	for (int m = 0; m < t->n / 2; m++) {
		int even = to_mirror ? last - 2 * m : 2 * m;
		double *low = lines + even * TS_LINES, *high = lines + (last - even) * TS_LINES;

		memcpy(low, x + m * TS_LINES, line);
#pragma omp simd
		for (int l = 0; l < TS_LINES; l++)
			high[l] = -y[m * TS_LINES + l];
	}
}

enum { BLOCK = 4 }; /* number of results computed at once, in registers */

TS_CLONES
static void multiply_block(const double *restrict matrix, int n, const double *restrict lines,
			   double *restrict out)
{
	double sum[BLOCK][TS_LINES] = { { 0 } };

	for (int i = 0; i < n; i++)
		for (int b = 0; b < BLOCK; b++)
#pragma omp simd
			for (int l = 0; l < TS_LINES; l++)
				sum[b][l] += matrix[b * n + i] * lines[i * TS_LINES + l];
	memcpy(out, sum, sizeof sum);
}

TS_CLONES
static void multiply_row(const double *restrict matrix, int n, const double *restrict lines,
			 double *restrict out)
{
	double sum[TS_LINES] = { 0 };

	for (int i = 0; i < n; i++)
#pragma omp simd
		for (int l = 0; l < TS_LINES; l++)
			sum[l] += matrix[i] * lines[i * TS_LINES + l];
	memcpy(out, sum, sizeof sum);
}

static void multiply_matrix(const double *matrix, int n, double *lines, double *spare)
{
	int row = 0;

	for (; row + BLOCK <= n; row += BLOCK)
		multiply_block(matrix + (size_t)row * (size_t)n, n, lines, spare + row * TS_LINES);
	for (; row < n; row++)
		multiply_row(matrix + (size_t)row * (size_t)n, n, lines, spare + row * TS_LINES);
	memcpy(lines, spare, (size_t)n * TS_LINES * sizeof *lines);
}

void ts_transform_forward(const struct ts_transform *t, double *lines, double *spare)
{
	size_t part = (size_t)t->n * HALF;

	switch (t->waves) {
	case TS_WAVES_MATRIX:
		multiply_matrix(t->forward, t->n, lines, spare);
		break;
	case TS_WAVES_QUARTER:
		transform_quarter_waves(t, 1, t->mirrored, false, lines, spare);
		break;
	default:
		pack_lines(t, lines, spare, spare + part);
		ts_fourier_apply(&t->fourier, HALF, spare, spare + part, spare + 2 * part);
		separate_spectra(t, spare, spare + part, lines);
	}
}

void ts_transform_backward(const struct ts_transform *t, double *lines, double *spare)
{
	size_t part = (size_t)t->n * HALF;

	switch (t->waves) {
	case TS_WAVES_MATRIX:
		multiply_matrix(t->backward, t->n, lines, spare);
		break;
	case TS_WAVES_QUARTER:
		transform_quarter_waves(t, 2.0 / t->n, false, t->mirrored, lines, spare);
		break;
	default:
		unite_spectra(t, lines, spare, spare + part);
		ts_fourier_apply(&t->fourier, HALF, spare + part, spare, spare + 2 * part);
		unpack_lines(t, spare, spare + part, lines);
	}
}
