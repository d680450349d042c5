/* Contact of rough solids: convolutions against direct sums; Hertz, Westergaard and full contact; yielding; the Winkler
 * foundation; moments of spectra, self-affine surfaces, theories of asperities. */
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "math/constants.h"
#include "math/rng.h"
#include "rough/asperity_theory.h"
#include "rough/half_space.h"
#include "rough/rough_contact.h"
#include "tests/deck.h"
#include "voxel/voxel_gaussian.h"
#include "voxel/voxel_self_affine.h"

/* ---- convolution ---- */

static double some_kernel(const void *context, int i, int j)
{
	(void)context;
	return 1 / (1 + 0.3 * i * i + 0.7 * j) + 0.01 * i;
}

static int distance_of(int a, int b, int n, bool periodic)
{
	int d = abs(a - b);

	return periodic && n - d < d ? n - d : d;
}

/* Largest difference from the direct sum. */
static double direct_difference(const int n[2], bool periodic, const double *in, const double *out)
{
	double most = 0;

	for (int j = 0; j < n[1]; j++)
		for (int i = 0; i < n[0]; i++) {
			double sum = 0;

			for (int l = 0; l < n[1]; l++)
				for (int k = 0; k < n[0]; k++)
					sum += in[l * n[0] + k] *
					       some_kernel(NULL, distance_of(i, k, n[0], periodic),
							   distance_of(j, l, n[1], periodic));
			most = fmax(most, fabs(sum - out[j * n[0] + i]));
		}
	return most;
}

START_TEST(convolutions_are_sums)
{
	static const int sizes[][2] = { { 1, 1 },   { 1, 7 },	{ 6, 1 },   { 5, 4 },
					{ 33, 18 }, { 40, 37 }, { 64, 16 }, { 2, 2 } };

	for (size_t s = 0; s < 2 * DECK_LENGTH(sizes); s++) {
		const int *n = sizes[s / 2];
		size_t cells = (size_t)(n[0] * n[1]);
		struct ts_rng rng = ts_rng_start(97, s);
		double *in = malloc(cells * sizeof *in), *out[2];
		struct ts_convolution c;

		for (size_t k = 0; k < cells; k++)
			in[k] = ts_rng_uniform(&rng) - 0.5;
		for (int threads = 1; threads <= 3; threads += 2) {
			double *to = out[threads / 2] = malloc(cells * sizeof *in);

			ck_assert(ts_convolution_make(&c, n, s % 2, threads) == TS_OK);
			ck_assert(ts_convolution_set_kernel(&c, some_kernel, NULL) == TS_OK);
			ck_assert(ts_convolution_apply(&c, in, to) == TS_OK);
			ts_convolution_release(&c);
		}
		DECK_NEAR(direct_difference(n, s % 2, in, out[0]), 0, 1e-13);
		ck_assert(!memcmp(out[0], out[1], cells * sizeof *in));
		free(in);
		free(out[0]);
		free(out[1]);
	}
}
END_TEST

/* ---- scenes ---- */

struct scene {
	struct ts_rough_problem problem;
	struct ts_rough_result result;
	double *height;
};

static struct scene make_scene(int nx, int ny, double size)
{
	size_t cells = (size_t)nx * (size_t)ny;
	struct scene s = { .problem = { .n = { nx, ny },
					.width = { size / nx, size / nx },
					.modulus = 1,
					.hardness = INFINITY,
					.tolerance = 1e-9,
					.iterations = 5000,
					.threads = 1 } };

	s.problem.height = s.height = malloc(cells * sizeof *s.height);
	s.result.pressure = malloc(cells * sizeof *s.height);
	s.result.gap = malloc(cells * sizeof *s.height);
	return s;
}

static void drop_scene(struct scene *s)
{
	free(s->height);
	free(s->result.pressure);
	free(s->result.gap);
}

static size_t cells_of(const struct scene *s)
{
	return (size_t)s->problem.n[0] * (size_t)s->problem.n[1];
}

/* Load, signs of pressure and gap, and the hardness are those of a contact. */
static void is_contact(const struct scene *s, double roughness)
{
	double sum = 0;

	for (size_t k = 0; k < cells_of(s); k++) {
		double p = s->result.pressure[k], gap = s->result.gap[k];

		sum += p;
		ck_assert(p >= 0 && p <= s->problem.hardness);
		ck_assert(p > 0 || gap >= -s->problem.tolerance * roughness);
		ck_assert(p <= 0 || gap <= s->problem.tolerance * roughness);
		ck_assert(p <= 0 || p >= s->problem.hardness ||
			  fabs(gap) <= s->problem.tolerance * roughness);
	}
	DECK_NEAR(sum / (double)cells_of(s) / s->problem.mean_pressure, 1, 1e-12);
}

/* A sphere of radius 1 on the unit square; its centre is the corner of four columns. */
static void make_sphere(struct scene *s)
{
	for (int j = 0; j < s->problem.n[1]; j++)
		for (int i = 0; i < s->problem.n[0]; i++) {
			double x = (i + 0.5) * s->problem.width[0] - 0.5,
			       y = (j + 0.5) * s->problem.width[1] - 0.5;

			s->height[j * s->problem.n[0] + i] = -(x * x + y * y) / 2;
		}
}

/* ---- half space ---- */

/* Root mean square difference, over the contact, of the pressures from the means over the columns (16 x 16 points) of
 * those of Hertz, 2 E* /(pi R) sqrt(a^2 - r^2), by the mean pressure of the contact. */
static double hertz_difference(const struct scene *s, double a)
{
	enum { POINTS = 16 };
	double square = 0;

	for (int j = 0; j < s->problem.n[1]; j++)
		for (int i = 0; i < s->problem.n[0]; i++) {
			double mean = 0;

			for (int k = 0; k < POINTS * POINTS; k++) {
				double x = (i + (k % POINTS + 0.5) / POINTS) * s->problem.width[0] - 0.5;
				double y = (j + (k / POINTS + 0.5) / POINTS) * s->problem.width[1] - 0.5;

				mean += 2 / TS_PI * sqrt(fmax(a * a - x * x - y * y, 0)) / (POINTS * POINTS);
			}
			mean -= s->result.pressure[j * s->problem.n[0] + i];
			square += mean * mean * s->problem.width[0] * s->problem.width[1];
		}
	return sqrt(square / (TS_PI * a * a)) / (4 * a / (3 * TS_PI));
}

/* Hertz: a^3 = 3 F R/(4 E*), approach a^2/R, largest pressure 2 E* a/(pi R). */
START_TEST(sphere_is_hertz)
{
	const double a = 0.3;
	double step[3], error[3], root[3];

	for (int k = 0; k < 3; k++) {
		int n = 32 << k;
		struct scene s = make_scene(n, n, 1);
		double area;

		make_sphere(&s);
		s.problem.mean_pressure = 4 * a * a * a / 3;
		ck_assert(ts_rough_half_space(&s.problem, &s.result) == TS_OK);
		is_contact(&s, 0.06);
		step[k] = 1.0 / n;
		error[k] = fabs(s.result.max_pressure / (2 * a / TS_PI) - 1);
		area = s.result.smooth_area / (TS_PI * a * a) - 1;
		root[k] = hertz_difference(&s, a);
		if (n == 128) {
			DECK_NEAR(-s.result.plane / (a * a), 1, 3e-5);
			DECK_NEAR(error[k], 0, 2e-4);
			DECK_NEAR(area, 0, 0.003);
		}
		drop_scene(&s);
	}
	ck_assert_msg(deck_order(step, error, 3) > 1.8, "order %g", deck_order(step, error, 3));
	/* first order, by the columns at the border */
	ck_assert_msg(root[2] < 0.006 && deck_order(step, root, 3) > 0.9, "pressures %g, order %g", root[2],
		      deck_order(step, root, 3));
}
END_TEST

/* Heights -f(r), r the distance from the middle of the unit square. */
static void make_body(struct scene *s, double (*f)(double r))
{
	for (int j = 0; j < s->problem.n[1]; j++)
		for (int i = 0; i < s->problem.n[0]; i++)
			s->height[j * s->problem.n[0] + i] = -f(hypot((i + 0.5) * s->problem.width[0] - 0.5,
								      (j + 0.5) * s->problem.width[1] - 0.5));
}

static double cone(double r)
{
	return 0.1 * r;
}

static double punch(double r)
{
	return r < 0.3 ? 0 : 1;
}

/* I. N. Sneddon, Int. J. Eng. Sci. 3 (1965) 47: a cone of slope m has the contact radius a with F = pi a^2 m E* /2 and the
 * approach pi a m/2; a flat punch of radius a the approach F/(2 E* a) and the pressure F/(2 pi a^2) in the middle. */
START_TEST(cone_and_punch_are_sneddon)
{
	const double a = 0.3, m = 0.1;
	double step[3], approach[3], punched[3];

	for (int k = 0; k < 3; k++) {
		int n = 64 << k;
		struct scene s = make_scene(n, n, 1);
		double load = TS_PI * a * a * m / 2;

		step[k] = 1.0 / n;
		s.problem.tolerance = 1e-7;
		s.problem.mean_pressure = load;
		make_body(&s, cone);
		ck_assert(ts_rough_half_space(&s.problem, &s.result) == TS_OK);
		is_contact(&s, 0.03);
		approach[k] = fabs(-s.result.plane / (TS_PI * a * m / 2) - 1);
		DECK_NEAR(s.result.smooth_area / (TS_PI * a * a), 1, 1.3 / n);
		make_body(&s, punch);
		ck_assert(ts_rough_half_space(&s.problem, &s.result) == TS_OK);
		punched[k] = fabs(-s.result.plane / (load / (2 * a)) - 1);
		DECK_NEAR(s.result.pressure[n / 2 * n + n / 2] / (load / (2 * TS_PI * a * a)), 1, 2.0 / n);
		is_contact(&s, 0.5);
		drop_scene(&s);
	}
	ck_assert_msg(approach[0] < 1e-4 && deck_order(step, approach, 3) > 1.6, "cone: %g, order %g",
		      approach[0], deck_order(step, approach, 3));
	ck_assert_msg(punched[2] < 0.002 && deck_order(step, punched, 3) > 0.9, "punch: %g, order %g",
		      punched[2], deck_order(step, punched, 3));
}
END_TEST

/* K. L. Johnson, J. A. Greenwood, J. G. Higginson, Int. J. Mech. Sci. 27 (1985) 383: heights A cos(2 pi x) cos(2 pi y),
 * p* = sqrt(2) pi E* A: full contact at p*; area pi (3 p/(8 pi p*))^(2/3) for small pressures, and
 * 1 - 3/(2 pi) (1 - p/p*) near p*. */
START_TEST(two_waves_are_johnson)
{
	const double amplitude = 0.01, full = sqrt(2) * TS_PI * amplitude;
	const double part[] = { 0.002, 0.97, 1.0001 };

	for (int k = 0; k < 3; k++) {
		int n = 256;
		struct scene s = make_scene(n, n, 1);
		double area = part[k] > 1     ? 1
			      : part[k] < 0.5 ? TS_PI * pow(3 * part[k] / (8 * TS_PI), 2.0 / 3)
					      : 1 - 1.5 / TS_PI * (1 - part[k]);

		for (int c = 0; c < n * n; c++)
			s.height[c] = amplitude * cos(2 * TS_PI * (c % n) / n) *
				      cos(2 * TS_PI * (double)(c / n) / n);
		s.problem.periodic = true;
		s.problem.tolerance = 1e-7;
		s.problem.mean_pressure = part[k] * full;
		ck_assert(ts_rough_half_space(&s.problem, &s.result) == TS_OK);
		is_contact(&s, amplitude);
		/* the formulas are limits; relative to the smaller part, in contact or not */
		DECK_NEAR(s.result.smooth_area, area, 0.02 * fmin(area, 1 - area));
		drop_scene(&s);
	}
}
END_TEST

/* H. M. Westergaard, J. Appl. Mech. 6 (1939) 49: a wave of amplitude A and length 1, p* = pi E* A: in contact over the
 * width 2a, sin^2(pi a) = p/p*, with the pressure 2 p cos(pi x)/sin^2(pi a) sqrt(sin^2(pi a) - sin^2(pi x)). */
START_TEST(wave_is_westergaard)
{
	const double amplitude = 0.01, full = TS_PI * amplitude, part = 0.4;
	double step[3], error[3];

	for (int k = 0; k < 3; k++) {
		int n = 64 << 2 * k;
		struct scene s = make_scene(n, 1, 1);
		double square = 0;

		for (int i = 0; i < n; i++)
			s.height[i] = amplitude * cos(2 * TS_PI * (i + 0.5) / n);
		s.problem.periodic = true;
		s.problem.mean_pressure = part * full;
		ck_assert(ts_rough_half_space(&s.problem, &s.result) == TS_OK);
		is_contact(&s, amplitude);
		for (int i = 0; i < n; i++) {
			double sine = sin(TS_PI * (i + 0.5) / n), root = sqrt(fmax(part - sine * sine, 0));
			double p = 2 * part * full * fabs(cos(TS_PI * (i + 0.5) / n)) / part * root;

			square += (s.result.pressure[i] - p) * (s.result.pressure[i] - p) / n;
		}
		step[k] = 1.0 / n;
		error[k] = sqrt(square) / full;
		DECK_NEAR(s.result.area, 2 * asin(sqrt(part)) / TS_PI, 2.0 / n);
		drop_scene(&s);
	}
	ck_assert_msg(error[2] < 2e-4 && deck_order(step, error, 3) > 0.95, "error %g, order %g", error[2],
		      deck_order(step, error, 3));
}
END_TEST

/* Above p* the contact is complete, and the pressure p + E* q h/2, exactly. */
START_TEST(full_contact_is_exact)
{
	struct scene s = make_scene(48, 36, 1);
	const double qx = 2 * TS_PI * 2, qy = 2 * TS_PI * 3 / 0.75, A = 1e-3;

	for (int k = 0; k < 48 * 36; k++)
		s.height[k] = A * cos(qx * (k % 48) / 48 * 1.0) * cos(qy * (double)(k / 48) / 48);
	s.problem.periodic = true;
	s.problem.mean_pressure = 0.6 * A * hypot(qx, qy);
	ck_assert(ts_rough_half_space(&s.problem, &s.result) == TS_OK);
	DECK_NEAR(s.result.area, 1, 0);
	DECK_NEAR(s.result.smooth_area, 1, 0);
	for (size_t k = 0; k < cells_of(&s); k++)
		DECK_NEAR(s.result.pressure[k] / s.problem.mean_pressure,
			  1 + hypot(qx, qy) * s.height[k] / 2 / s.problem.mean_pressure, 1e-8);
	drop_scene(&s);
}
END_TEST

/* A hardness far below the elastic pressure: all of the contact yields, but for its border: area = load/hardness. */
START_TEST(soft_sphere_yields)
{
	struct scene s = make_scene(96, 96, 1);

	make_sphere(&s);
	s.problem.hardness = 0.02;
	s.problem.mean_pressure = 0.002;
	s.problem.tolerance = 1e-6;
	ck_assert(ts_rough_half_space(&s.problem, &s.result) == TS_OK);
	is_contact(&s, 0.06);
	DECK_NEAR(s.result.max_pressure, 0.02, 0);
	DECK_NEAR(s.result.area, 0.1, 0.012);
	ck_assert(s.result.plastic_area > 0.07 && s.result.plastic_area < s.result.area);
	s.problem.mean_pressure = 0.02;
	ck_assert(ts_rough_half_space(&s.problem, &s.result) == TS_RANGE);
	ck_assert(ts_rough_winkler(&s.problem, &s.result) == TS_RANGE);
	drop_scene(&s);
}
END_TEST

/* A sphere begins to yield where the largest pressure of Hertz, 2 E* a/(pi R), is the hardness. */
START_TEST(sphere_begins_to_yield)
{
	for (int k = 0; k < 2; k++) {
		struct scene s = make_scene(128, 128, 1);

		make_sphere(&s);
		s.problem.mean_pressure = 4 * 0.027 / 3;
		s.problem.hardness = (k ? 0.999 : 1.001) * 0.6 / TS_PI;
		ck_assert(ts_rough_half_space(&s.problem, &s.result) == TS_OK);
		is_contact(&s, 0.06);
		ck_assert((s.result.plastic_area > 0) == (k == 1));
		drop_scene(&s);
	}
}
END_TEST

START_TEST(few_iterations_are_reported)
{
	struct scene s = make_scene(64, 64, 1);

	make_sphere(&s);
	s.problem.mean_pressure = 0.03;
	s.problem.iterations = 3;
	ck_assert(ts_rough_half_space(&s.problem, &s.result) == TS_PHYSICS);
	ck_assert(s.result.residual > s.problem.tolerance);
	drop_scene(&s);
}
END_TEST

/* Lengths in micrometres and pressures in pascal: the same contact. Surfaces that are flat touch everywhere. */
START_TEST(units_do_not_matter)
{
	struct scene si = make_scene(40, 40, 1), tiny = make_scene(40, 40, 1e-6);

	make_sphere(&si);
	for (size_t k = 0; k < cells_of(&si); k++)
		tiny.height[k] = 1e-6 * si.height[k];
	si.problem.mean_pressure = 0.02;
	tiny.problem.modulus = 7e10;
	tiny.problem.mean_pressure = 0.02 * 7e10;
	ck_assert(ts_rough_half_space(&si.problem, &si.result) == TS_OK);
	ck_assert(ts_rough_half_space(&tiny.problem, &tiny.result) == TS_OK);
	DECK_NEAR(tiny.result.plane / si.result.plane, 1e-6, 1e-14);
	DECK_NEAR(tiny.result.area, si.result.area, 0);
	memset(si.height, 0, cells_of(&si) * sizeof *si.height);
	si.problem.periodic = true;
	ck_assert(ts_rough_half_space(&si.problem, &si.result) == TS_OK);
	DECK_NEAR(si.result.area, 1, 0);
	DECK_NEAR(si.result.max_pressure, 0.02, 1e-16);
	drop_scene(&si);
	drop_scene(&tiny);
}
END_TEST

/* ---- winkler ---- */

/* Heights 0, 1 .. n-1 over n: with the plane at d the columns above it carry stiffness (h - d), at most the hardness. */
START_TEST(springs_are_exact)
{
	enum { N = 1000 };
	struct scene s = make_scene(N, 1, 1);
	double sum = 0, plane = 0.7313;

	for (int k = 0; k < N; k++)
		s.height[k] = (double)((k * 37) % N) / N;
	s.problem.stiffness = 5;
	for (int k = 0; k < N; k++)
		sum += fmax(5 * (s.height[k] - plane), 0);
	s.problem.mean_pressure = sum / N;
	ck_assert(ts_rough_winkler(&s.problem, &s.result) == TS_OK);
	DECK_NEAR(s.result.plane, plane, 1e-14);
	DECK_NEAR(s.result.area, 0.268, 1e-14);
	DECK_NEAR(s.result.max_pressure, 5 * (0.999 - plane), 1e-13);
	is_contact(&s, 1);
	s.problem.hardness = 0.5; /* reached 0.1 below the plane */
	sum = 0;
	for (int k = 0; k < N; k++)
		sum += fmin(fmax(5 * (s.height[k] - plane), 0), 0.5);
	s.problem.mean_pressure = sum / N;
	ck_assert(ts_rough_winkler(&s.problem, &s.result) == TS_OK);
	DECK_NEAR(s.result.plane, plane, 1e-14);
	DECK_NEAR(s.result.plastic_area, 0.168, 1e-14);
	drop_scene(&s);
}
END_TEST

/* ---- statistics ---- */

START_TEST(moments_of_a_wave)
{
	enum { NX = 32, NY = 18 };
	double h[NX * NY], qx = 2 * TS_PI * 3 / 2.0, qy = 2 * TS_PI * 2 / 4.5, q2 = qx * qx + qy * qy;
	struct ts_rough_moments m;

	for (int k = 0; k < NX * NY; k++)
		h[k] = 5 + 0.1 * cos(qx * (k % NX) / 16.0 + qy * (double)(k / NX) / 4.0);
	ck_assert(ts_rough_moments((int[]){ NX, NY }, (double[]){ 1 / 16.0, 0.25 }, h, &m) == TS_OK);
	DECK_NEAR(m.m0, 0.005, 1e-15);
	DECK_NEAR(m.m2, 0.005 * q2 / 2, 1e-12);
	DECK_NEAR(m.m4, 3.0 / 8 * 0.005 * q2 * q2, 1e-10);
}
END_TEST

/* The spectrum, averaged over samples, by its moments; sums over the waves of the grid. */
START_TEST(self_affine_spectrum)
{
	enum { N = 96, SAMPLES = 40 };
	struct ts_voxel_self_affine s = { .n = { N, N },
					  .width = { 1.0 / N, 1.0 / N },
					  .mean = 3,
					  .deviation = 0.02,
					  .hurst = 0.8,
					  .longest = 0.5,
					  .roll = 0.2,
					  .shortest = 1.0 / 32 };
	double *h = malloc(N * N * sizeof *h), power = 0, slope = 0, m0 = 0, m2 = 0;
	struct ts_rough_moments m;

	for (int l = -N / 2; l < N / 2; l++)
		for (int k = -N / 2; k < N / 2; k++) {
			double waves = hypot(k, l); /* per length */
			double c = waves < 2 - 1e-9 || waves > 32 + 1e-9 ? 0
				   : waves < 5				 ? 1
									 : pow(waves / 5, -3.6);

			power += c;
			slope += c * pow(2 * TS_PI * waves, 2) / 2;
		}
	for (uint64_t k = 1; k <= SAMPLES; k++) {
		s.seed = k;
		ck_assert(ts_voxel_self_affine(&s, h) == TS_OK);
		ck_assert(ts_rough_moments(s.n, s.width, h, &m) == TS_OK);
		m0 += m.m0 / SAMPLES;
		m2 += m.m2 / SAMPLES;
	}
	DECK_NEAR(m0 / (0.02 * 0.02), 1, 0.05);
	DECK_NEAR(m2 / m0 / (slope / power), 1, 0.03);
	s.exact = true;
	ck_assert(ts_voxel_self_affine(&s, h) == TS_OK);
	ck_assert(ts_rough_moments(s.n, s.width, h, &m) == TS_OK);
	DECK_NEAR(sqrt(m.m0) / 0.02, 1, 1e-12);
	s.longest = s.roll = s.shortest = 0.9997;
	ck_assert(ts_voxel_self_affine(&s, h) == TS_RANGE);
	free(h);
}
END_TEST

/* Largest difference of two fields, of n and of 3 n columns, where their columns have the same centre. */
static double finer_difference(const int n[2], const double *coarse, const double *fine)
{
	double most = 0;

	for (int j = 0; j < n[1]; j++)
		for (int i = 0; i < n[0]; i++)
			most = fmax(most,
				    fabs(coarse[j * n[0] + i] - fine[(3 * j + 1) * 3 * n[0] + 3 * i + 1]));
	return most;
}

/* With noise of waves a surface is the same on any grid that resolves it; with that of columns it is not. */
START_TEST(waves_do_not_depend_on_columns)
{
	enum { NX = 36, NY = 21 };
	double h[2][9 * NX * NY], g[2][9 * NX * NY];

	for (int noise = TS_VOXEL_NOISE_COLUMNS; noise <= TS_VOXEL_NOISE_WAVES; noise++) {
		for (int k = 0; k < 2; k++) {
			const int finer = k ? 3 : 1, n[2] = { NX * finer, NY * finer };
			const double width = 1.0 / n[0];
			struct ts_voxel_self_affine s = { .n = { n[0], n[1] },
							  .width = { width, width },
							  .mean = 2,
							  .deviation = 1,
							  .hurst = 0.7,
							  .longest = 1,
							  .roll = 0.4,
							  .shortest = 1.0 / 10,
							  .seed = 5,
							  .noise = (enum ts_voxel_noise_kind)noise,
							  .exact = true };
			struct ts_voxel_gaussian t = { .n = { n[0], n[1] },
						       .width = { width, width },
						       .deviation = 1,
						       .correlation = { 0.2, 0.25 },
						       .seed = 6,
						       .noise = s.noise };

			ck_assert(ts_voxel_self_affine(&s, h[k]) == TS_OK);
			ck_assert(ts_voxel_gaussian(&t, g[k]) == TS_OK);
		}
		if (noise == TS_VOXEL_NOISE_WAVES) {
			DECK_NEAR(finer_difference((int[]){ NX, NY }, h[0], h[1]), 0, 1e-13);
			DECK_NEAR(finer_difference((int[]){ NX, NY }, g[0], g[1]), 0, 1e-13);
		} else
			ck_assert(finer_difference((int[]){ NX, NY }, h[0], h[1]) > 0.1);
	}
}
END_TEST

/* Each number of the noise of waves has variance 1 and no correlation with others, as that of columns. */
START_TEST(waves_are_white_noise)
{
	enum { NX = 12, NY = 9, SAMPLES = 4000 };
	double h[NX * NY], product[NX * NY] = { 0 };

	for (uint64_t seed = 1; seed <= SAMPLES; seed++) {
		ck_assert(ts_voxel_noise(TS_VOXEL_NOISE_WAVES, seed, (int[]){ NX, NY }, h) == TS_OK);
		for (int k = 0; k < NX * NY; k++)
			product[k] += h[17] * h[k] / SAMPLES;
	}
	for (int k = 0; k < NX * NY;
	     k++) /* standard error 1/sqrt(4000) = 0.016, sqrt(2) as much for the variance */
		DECK_NEAR(product[k], k == 17, 0.07);
}
END_TEST

/* Area over p/(E* sqrt<|grad h|^2>) at small loads: solutions for self-affine surfaces lie between Persson's theory,
 * sqrt(8/pi), and that of Bush, Gibson and Thomas, sqrt(2 pi). The corrected area depends little on the columns. */
START_TEST(area_of_rough_contact)
{
	double kappa[2];

	for (int k = 0; k < 2; k++) {
		int n = 128 << k;
		struct scene s = make_scene(n, n, 1);
		struct ts_voxel_self_affine surface = { .n = { n, n },
							.width = { 1.0 / n, 1.0 / n },
							.deviation = 1e-3,
							.hurst = 0.8,
							.longest = 0.25,
							.roll = 0.25,
							.shortest = 1.0 / 16,
							.seed = 3,
							.exact = true };
		struct ts_rough_moments m;
		double slope;

		ck_assert(ts_voxel_self_affine(&surface, s.height) == TS_OK);
		ck_assert(ts_rough_moments(s.problem.n, s.problem.width, s.height, &m) == TS_OK);
		slope = sqrt(2 * m.m2);
		s.problem.periodic = true;
		s.problem.tolerance = 1e-5;
		s.problem.mean_pressure = 0.04 * slope;
		ck_assert(ts_rough_half_space(&s.problem, &s.result) == TS_OK);
		is_contact(&s, 1e-3);
		kappa[k] = s.result.smooth_area / 0.04;
		ck_assert(s.result.smooth_area > ts_rough_persson_area(&m, s.problem.mean_pressure));
		ck_assert(s.result.smooth_area < ts_rough_bush_area(&m, s.problem.mean_pressure));
		drop_scene(&s);
	}
	ck_assert_msg(kappa[0] > 1.9 && kappa[0] < 2.4, "kappa %g", kappa[0]);
	DECK_NEAR(kappa[0] / kappa[1], 1, 0.06);
}
END_TEST

/* kappa = area over p/(E* g), g = rms gradient, at 0.1, and u0 = -du/d ln p of the mean gap u from 0.05 to 0.1 in standard
 * deviations of the heights: means over random surfaces, and the standard error of kappa. */
struct rough_numbers {
	double kappa, error, slope;
};

static struct rough_numbers measure_rough(double shortest)
{
	enum { N = 192, SURFACES = 6 };
	struct scene s = make_scene(N, N, 1);
	struct ts_voxel_self_affine surface = { .n = { N, N },
						.width = { 1.0 / N, 1.0 / N },
						.deviation = 1e-3,
						.hurst = 0.8,
						.longest = 0.25,
						.roll = 0.25,
						.shortest = shortest,
						.noise = TS_VOXEL_NOISE_WAVES,
						.exact = true };
	struct rough_numbers out = { 0, 0, 0 };
	struct ts_rough_moments m;
	double square = 0, gap;

	s.problem.periodic = true;
	s.problem.tolerance = 1e-4;
	for (surface.seed = 1; surface.seed <= SURFACES; surface.seed++) {
		ck_assert(ts_voxel_self_affine(&surface, s.height) == TS_OK);
		ck_assert(ts_rough_moments(s.problem.n, s.problem.width, s.height, &m) == TS_OK);
		s.problem.mean_pressure = 0.05 * sqrt(2 * m.m2);
		ck_assert(ts_rough_half_space(&s.problem, &s.result) == TS_OK);
		gap = s.result.mean_gap;
		s.problem.mean_pressure *= 2;
		ck_assert(ts_rough_half_space(&s.problem, &s.result) == TS_OK);
		out.slope += (gap - s.result.mean_gap) / (log(2) * 1e-3 * SURFACES);
		out.kappa += s.result.smooth_area / (0.1 * SURFACES);
		square += s.result.smooth_area * s.result.smooth_area / (0.01 * SURFACES);
	}
	out.error = sqrt(fmax(square - out.kappa * out.kappa, 0) / (SURFACES - 1));
	drop_scene(&s);
	return out;
}

/* Published of self-affine surfaces: kappa is slightly greater than 2 (J. S. van Dokkum et al, Tribol. Lett. 66 (2018) 115), and
 * falls with the breadth of the spectrum (V. A. Yastrebov et al, J. Mech. Phys. Solids 107 (2017) 469); p ~ exp(-u/u0) with u0 of
 * the order of the deviation (B. Lorenz, B. N. J. Persson, J. Phys.: Condens. Matter 21 (2009) 015003). */
START_TEST(rough_contact_as_published)
{
	struct rough_numbers narrow = measure_rough(1.0 / 8), broad = measure_rough(1.0 / 32);

	ck_assert_msg(narrow.kappa < 2.3 && broad.kappa > 1.9, "kappa %g, %g", narrow.kappa, broad.kappa);
	ck_assert_msg(narrow.kappa - broad.kappa > hypot(narrow.error, broad.error),
		      "kappa %g +- %g, %g +- %g", narrow.kappa, narrow.error, broad.kappa, broad.error);
	DECK_NEAR(narrow.slope, 0.47, 0.04);
	DECK_NEAR(broad.slope, 0.48, 0.04);
}
END_TEST

START_TEST(theories_in_their_limits)
{
	const struct ts_rough_moments m = { 1e-12, 0.02, 4e9 };
	struct ts_rough_asperities a;
	double load;

	/* d area/d (p/E*) -> sqrt(8/pi)/sqrt(2 m2) */
	DECK_NEAR(ts_rough_persson_area(&m, 1e-9) * sqrt(2 * m.m2) / 1e-9, sqrt(8 / TS_PI), 1e-9);
	DECK_NEAR(ts_rough_persson_area(&m, 10), 1, 1e-15);
	DECK_NEAR(ts_rough_bush_area(&m, 1e-9) * sqrt(2 * m.m2) / 1e-9, sqrt(2 * TS_PI), 1e-12);
	ts_rough_asperities(&m, &a);
	/* int_0^inf x^(3/2) exp(-x^2/2)/sqrt(2 pi) dx = 2^(1/4) gamma(5/4)/sqrt(2 pi) */
	load = 4.0 / 3 * a.density * sqrt(a.radius) * pow(a.deviation, 1.5) * pow(2, 0.25) * tgamma(1.25) /
	       sqrt(2 * TS_PI);
	DECK_NEAR(ts_rough_greenwood_pressure(&a, 0) / load, 1, 1e-11);
	DECK_NEAR(ts_rough_greenwood_area(&a, 0) / (a.density * a.radius * a.deviation * sqrt(TS_PI / 2)), 1,
		  1e-13);
	for (double p = 1e-8; p < 1e-2; p *= 10) {
		double d = ts_rough_greenwood_distance(&a, p);

		DECK_NEAR(ts_rough_greenwood_pressure(&a, d) / p, 1, 1e-9);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("rough");
	TCase *contact = tcase_create("contact"), *statistics = tcase_create("statistics");

	tcase_set_timeout(contact, 60);
	tcase_add_test(contact, convolutions_are_sums);
	tcase_add_test(contact, sphere_is_hertz);
	tcase_add_test(contact, cone_and_punch_are_sneddon);
	tcase_add_test(contact, two_waves_are_johnson);
	tcase_add_test(contact, wave_is_westergaard);
	tcase_add_test(contact, full_contact_is_exact);
	tcase_add_test(contact, soft_sphere_yields);
	tcase_add_test(contact, sphere_begins_to_yield);
	tcase_add_test(contact, few_iterations_are_reported);
	tcase_add_test(contact, units_do_not_matter);
	tcase_add_test(contact, springs_are_exact);
	tcase_add_test(contact, area_of_rough_contact);
	tcase_add_test(contact, rough_contact_as_published);
	suite_add_tcase(suite, contact);
	tcase_set_timeout(statistics, 60);
	tcase_add_test(statistics, moments_of_a_wave);
	tcase_add_test(statistics, self_affine_spectrum);
	tcase_add_test(statistics, waves_do_not_depend_on_columns);
	tcase_add_test(statistics, waves_are_white_noise);
	tcase_add_test(statistics, theories_in_their_limits);
	suite_add_tcase(suite, statistics);
	return deck_main(suite);
}
