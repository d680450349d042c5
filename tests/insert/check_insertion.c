/* What insertion is made of: the generator, spreads of sizes, the search for overlaps. */
#include <math.h>
#include <stdlib.h>

#include "asserts.h"
#include "geom/spherehash.h"
#include "insert/nozzle.h"
#include "math/constants.h"
#include "math/minstd.h"
#include "math/rng.h"
#include "math/size_spread.h"
#include "math/vec3.h"
#include "rigid/clump.h"

/* Park and Miller give the 10000th number after the seed 1. */
START_TEST(minstd_is_that_of_park_and_miller)
{
	struct ts_minstd r = ts_minstd_start(1);

	for (int k = 0; k < 10000; k++)
		(void)ts_minstd_uniform(&r);
	ck_assert_int_eq(r.state, 1043618065);
	ck_assert(ts_minstd_is_prime(10007) && ts_minstd_is_prime(2147483629) && ts_minstd_is_prime(2));
	ck_assert(!ts_minstd_is_prime(10001) && !ts_minstd_is_prime(1) && !ts_minstd_is_prime(9));
}
END_TEST

START_TEST(minstd_normal_has_its_moments)
{
	struct ts_minstd r = ts_minstd_start(15485863);
	double sum = 0, square = 0, fourth = 0;
	const int n = 200000;

	for (int k = 0; k < n; k++) {
		double u = ts_minstd_normal(&r);

		sum += u;
		square += u * u;
		fourth += u * u * u * u;
	}
	ck_assert_double_eq_tol(sum / n, 0, 4 / sqrt(n));
	ck_assert_double_eq_tol(square / n, 1, 4 * sqrt(2.0 / n));
	ck_assert_double_eq_tol(fourth / n, 3, 4 * sqrt(96.0 / n));
}
END_TEST

/* The mean of drawn numbers is the mean that is promised, to four standard errors. */
static void compare_means(const struct ts_spread *s, int power)
{
	struct ts_minstd r = ts_minstd_start(32452843);
	double sum = 0, square = 0, mean = ts_spread_mean(s, power);
	const int n = 10000;

	for (int k = 0; k < n; k++) {
		double x = ts_spread_draw(s, &r), u = pow(x, power);

		ck_assert(x >= ts_spread_smallest(s) && x <= ts_spread_largest(s));
		sum += u;
		square += u * u;
	}
	ck_assert_double_eq_tol(sum / n, mean, 4 * sqrt((square / n - mean * mean) / n));
}

START_TEST(spreads_have_their_means)
{
	const struct ts_spread spreads[] = {
		{ TS_SPREAD_UNIFORM, false, 0.7, 2.385 },   { TS_SPREAD_UNIFORM, true, 0.7, 2.385 },
		{ TS_SPREAD_NORMAL, false, 2.385, 0.31 },   { TS_SPREAD_NORMAL, true, 2.385, 0.31 },
		{ TS_SPREAD_LOGNORMAL, false, 2.385, 0.2 }, { TS_SPREAD_LOGNORMAL, true, 2.385, 0.2 },
	};
	struct ts_spread constant = { TS_SPREAD_CONSTANT, false, 2.385, 0 };
	struct ts_minstd r = ts_minstd_start(17);

	for (size_t k = 0; k < sizeof spreads / sizeof *spreads; k++) {
		compare_means(&spreads[k], 1);
		compare_means(&spreads[k], 3);
	}
	ck_assert(ts_spread_draw(&constant, &r) == 2.385 && r.state == 17);
	ck_assert_double_eq_tol(ts_spread_mean(&constant, 3), 2.385 * 2.385 * 2.385, 1e-14);
}
END_TEST

/* Closed forms: E[r^3] of a uniform spread, by number and, with density 1/r^3, by mass. */
START_TEST(uniform_means_are_exact)
{
	const double a = 0.7, b = 2.385;
	const struct ts_spread number = { TS_SPREAD_UNIFORM, false, a, b };
	const struct ts_spread mass = { TS_SPREAD_UNIFORM, true, a, b };

	ck_assert_double_eq_tol(ts_spread_mean(&number, 3), (a + b) * (a * a + b * b) / 4, 1e-13);
	ck_assert_double_eq_tol(ts_spread_mean(&mass, 3), 2 * (b - a) / (1 / (a * a) - 1 / (b * b)), 1e-10);
}
END_TEST

/* Two unit spheres that touch, and a small one within: a body of volume 2 x 4 pi / 3 whose moments follow
 * from Steiner's theorem; the sphere around it is exact. To four standard errors. */
START_TEST(clump_has_the_moments_of_its_spheres)
{
	struct ts_clump_sphere spheres[] = { { { 1, 2, 3 }, 1 }, { { 1, 2, 5 }, 1 }, { { 1, 2, 3.1 }, 0.3 } };
	struct ts_clump clump = { .sphere = spheres, .n = 3 };
	struct ts_minstd r = ts_minstd_start(15485863);
	const int n = 200000;
	double volume = 8.0 / 3.0 * 3.14159265358979, tolerance = 4 / sqrt(n);

	ck_assert(ts_clump_measure(&clump, n, &r) == TS_OK);
	ck_assert_double_eq_tol(clump.reach, 2, 1e-14);
	ck_assert_double_eq_tol(clump.middle[2], 4, 1e-14);
	ck_assert_double_eq_tol(clump.volume / volume, 1, tolerance);
	ck_assert_double_eq_tol(clump.centre[0], 1, tolerance);
	ck_assert_double_eq_tol(clump.centre[2], 4, 2 * tolerance);
	ck_assert_double_eq_tol(clump.moments[0] / (volume * 1.4), 1, 2 * tolerance);
	ck_assert_double_eq_tol(clump.moments[1] / (volume * 1.4), 1, 2 * tolerance);
	ck_assert_double_eq_tol(clump.moments[2] / (volume * 0.4), 1, 2 * tolerance);
	for (int k = 3; k < 6; k++)
		ck_assert_double_eq_tol(clump.moments[k] / volume, 0, tolerance);
}
END_TEST

/* ---- nozzles */

static const double directions[][3] = {
	{ 0, 0, -1 }, { 2.385, 0, 0 }, { 0.3, -0.7, 0.2 }, { -1e-9, 3e-9, 0 }
};

START_TEST(nozzle_has_a_frame)
{
	for (size_t k = 0; k < sizeof directions / sizeof *directions; k++) {
		struct ts_nozzle n = { .outer = 1 };
		const double *e[3] = { n.side[0], n.side[1], n.axis };

		ts_nozzle_orient(&n, directions[k]);
		ck_assert_double_eq_tol(ts_dot(n.axis, directions[k]) / ts_norm(directions[k]), 1, 1e-15);
		for (int i = 0; i < 3; i++)
			for (int j = 0; j < 3; j++)
				ck_assert_double_eq_tol(ts_dot(e[i], e[j]), i == j, 1e-15);
	}
}
END_TEST

enum { NOZZLE_DRAWS = 100000 };

/* Uniform over a ring: r^2 is uniform between the squares of its radii, the mean position is the centre. */
START_TEST(nozzle_points_fill_the_ring)
{
	struct ts_nozzle n = { .centre = { 1, 2, 3 }, .outer = 1.1, .inner = 0.6 };
	struct ts_minstd r = ts_minstd_start(32452843);
	double sum = 0, mean[3] = { 0 }, lo = 0.7 * 0.7, hi = 1;

	ts_nozzle_orient(&n, directions[2]);
	for (int k = 0; k < NOZZLE_DRAWS; k++) {
		double x[3], d[3], d2;

		ts_nozzle_draw_point(&n, 0.1, &r, x);
		ts_sub(x, n.centre, d);
		d2 = ts_dot(d, d);
		ck_assert(fabs(ts_dot(d, n.axis)) < 1e-14 && d2 > lo - 1e-14 && d2 < hi + 1e-14);
		sum += d2;
		ts_axpy(1.0 / NOZZLE_DRAWS, d, mean);
	}
	ck_assert_double_eq_tol(sum / NOZZLE_DRAWS, (lo + hi) / 2, 4 * (hi - lo) / sqrt(12.0 * NOZZLE_DRAWS));
	for (int i = 0; i < 2; i++)
		ck_assert_double_eq_tol(ts_dot(mean, n.side[i]), 0, 4 * sqrt((lo + hi) / 4 / NOZZLE_DRAWS));
}
END_TEST

/* Means of cos t and cos^2 t over the density w(t) sin t, by the midpoint rule. */
static void cone_means(const struct ts_nozzle *n, double mean[2])
{
	const int steps = 20000;
	double widest = ts_nozzle_widest(n), weights = 0;

	mean[0] = mean[1] = 0;
	for (int k = 0; k < steps; k++) {
		double t = widest * (k + 0.5) / steps, w = sin(t);

		if (n->cone == TS_CONE_GAUSSIAN)
			w *= exp(-0.5 * t * t / (n->angle * n->angle));
		weights += w;
		mean[0] += w * cos(t);
		mean[1] += w * cos(t) * cos(t);
	}
	mean[0] /= weights;
	mean[1] /= weights;
}

static void compare_cone(struct ts_nozzle n)
{
	struct ts_minstd r = ts_minstd_start(15485863);
	double expected[2], cosines = 0, sum[3] = { 0 }, error;

	ts_nozzle_orient(&n, directions[2]);
	cone_means(&n, expected);
	for (int k = 0; k < NOZZLE_DRAWS; k++) {
		double e[3];

		ts_nozzle_draw_direction(&n, &r, e);
		ck_assert(fabs(ts_norm(e) - 1) < 1e-14);
		ck_assert(ts_dot(e, n.axis) >= cos(ts_nozzle_widest(&n)) - 1e-14);
		cosines += ts_dot(e, n.axis);
		ts_axpy(1.0 / NOZZLE_DRAWS, e, sum);
	}
	error = 4 * sqrt((expected[1] - expected[0] * expected[0]) / NOZZLE_DRAWS);
	ck_assert_double_eq_tol(cosines / NOZZLE_DRAWS, expected[0], error);
	for (int i = 0; i < 2; i++) /* <sin^2 t>/2 in each direction across */
		ck_assert_double_eq_tol(ts_dot(sum, n.side[i]), 0,
					4 * sqrt((1 - expected[1]) / 2 / NOZZLE_DRAWS));
}

START_TEST(nozzle_directions_fill_the_cone)
{
	struct ts_minstd r = ts_minstd_start(17);
	struct ts_nozzle n = { .outer = 1 };
	double e[3];

	compare_cone((struct ts_nozzle){ .cone = TS_CONE_UNIFORM, .angle = 1.2 });
	compare_cone((struct ts_nozzle){ .cone = TS_CONE_UNIFORM, .angle = TS_PI / 2 });
	compare_cone((struct ts_nozzle){ .cone = TS_CONE_GAUSSIAN, .angle = 0.05 });
	compare_cone((struct ts_nozzle){ .cone = TS_CONE_GAUSSIAN, .angle = TS_PI / 6 });
	ts_nozzle_orient(&n, directions[2]);
	ts_nozzle_draw_direction(&n, &r, e); /* parallel: no number is drawn */
	ck_assert(r.state == 17 && e[0] == n.axis[0] && e[1] == n.axis[1] && e[2] == n.axis[2]);
}
END_TEST

/* All lines of a linear cone meet in one apex, R/tan A behind the nozzle. */
START_TEST(nozzle_linear_cone_has_an_apex)
{
	struct ts_nozzle n = { .centre = { 1, 2, 3 }, .outer = 0.7, .cone = TS_CONE_LINEAR, .angle = 0.6 };
	struct ts_minstd r = ts_minstd_start(15485863);

	ts_nozzle_orient(&n, directions[2]);
	for (int k = 0; k < 1000; k++) {
		double x[3], e[3], apex[3], from[3];

		ts_nozzle_draw_point(&n, 0, &r, x);
		ts_nozzle_linear_direction(&n, x, e);
		ts_scale(1, n.centre, apex);
		ts_axpy(-n.outer / tan(n.angle), n.axis, apex);
		ts_sub(x, apex, from);
		ck_assert_double_eq_tol(ts_dot(e, from) / ts_norm(from), 1, 1e-14);
	}
}
END_TEST

enum { N = 600 };

/* Against all pairs: spheres whose radii span three decades, in a box periodic in two directions. */
START_TEST(spherehash_agrees_with_all_pairs)
{
	const struct ts_box box = { .lo = { -1.3, -0.2, 2 },
				    .hi = { 0.7, 1.9, 3.1 },
				    .face = { { TS_FACE_PERIODIC, TS_FACE_PERIODIC },
					      { TS_FACE_FIXED, TS_FACE_FIXED },
					      { TS_FACE_PERIODIC, TS_FACE_PERIODIC } } };
	struct ts_rng rng = ts_rng_start(86028157, 0);
	struct ts_spherehash hash = { 0 };
	static double x[N][3], radius[N];
	int found = 0;

	for (int i = 0; i < N; i++) {
		bool overlaps = false;

		radius[i] = 0.2 * pow(10, -3 * ts_rng_uniform(&rng));
		for (int d = 0; d < 3; d++)
			x[i][d] = box.lo[d] + ts_box_length(&box, d) * ts_rng_uniform(&rng);
		for (int j = 0; j < i; j++) {
			double r[3];

			ts_sub(x[i], x[j], r);
			ts_box_nearest(&box, r);
			overlaps |= ts_norm(r) <= radius[i] + radius[j];
		}
		ck_assert(ts_spherehash_overlaps_periodic(&hash, &box, x[i], radius[i]) == overlaps);
		ck_assert(ts_spherehash_add(&hash, x[i], radius[i]) == TS_OK);
		found += overlaps;
	}
	ck_assert_int_gt(found, N / 20);
	ck_assert_int_lt(found, N - N / 20);
	ts_spherehash_release(&hash);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("insertion");
	TCase *tests = tcase_create("insertion");
	SRunner *runner;
	int failed;

	tcase_add_test(tests, minstd_is_that_of_park_and_miller);
	tcase_add_test(tests, minstd_normal_has_its_moments);
	tcase_add_test(tests, spreads_have_their_means);
	tcase_add_test(tests, uniform_means_are_exact);
	tcase_add_test(tests, clump_has_the_moments_of_its_spheres);
	tcase_add_test(tests, spherehash_agrees_with_all_pairs);
	tcase_add_test(tests, nozzle_has_a_frame);
	tcase_add_test(tests, nozzle_points_fill_the_ring);
	tcase_add_test(tests, nozzle_directions_fill_the_cone);
	tcase_add_test(tests, nozzle_linear_cone_has_an_apex);
	tcase_set_timeout(tests, 60);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
