/* The turning of rigid bodies, against the exact motion of a free top. */
#include <gsl/gsl_sf_elljac.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "math/rigid_turn.h"

static const double inertia[3] = { 1.1, 1.7, 2.385 };
/* Angular velocity about the principal axes at the start: turning nearly about the last one, and about
 * the first, so that both kinds of motion are tried. */
static const double start_of[2][3] = { { 0.31, 0, 1.13 }, { 1.3, 0, 0.23 } };

/* Landau & Lifshitz, Mechanics, paragraph 37: Jacobi's elliptic functions; with 2 E I2 > L^2 the axes
 * 1 and 3 change places. */
static void exact_omega(const double start[3], double t, double omega[3])
{
	double e2 = 0, l2 = 0, sn, cn, dn, rate, m;
	int a = 0, c = 2;

	for (int k = 0; k < 3; k++) {
		e2 += inertia[k] * start[k] * start[k];
		l2 += inertia[k] * inertia[k] * start[k] * start[k];
	}
	if (l2 < e2 * inertia[1]) {
		a = 2;
		c = 0;
	}
	rate = sqrt((inertia[c] - inertia[1]) * (l2 - e2 * inertia[a]) /
		    (inertia[a] * inertia[1] * inertia[c]));
	m = (inertia[1] - inertia[a]) * (e2 * inertia[c] - l2) /
	    ((inertia[c] - inertia[1]) * (l2 - e2 * inertia[a]));
	ck_assert_int_eq(gsl_sf_elljac_e(rate * t, m, &sn, &cn, &dn), 0);
	omega[a] = start[a] * cn;
	omega[c] = start[c] * dn;
	omega[1] = sqrt((e2 * inertia[c] - l2) / (inertia[1] * (inertia[c] - inertia[1]))) * sn;
}

/* The largest error of the angular velocity in the frame of the body, at t = 7.3. Its sign about the
 * second axis depends on how the axes are numbered. */
static double error_after(const double start[3], int steps)
{
	const double t = 7.3;
	double q[4] = { 1, 0, 0, 0 }, spin[3], omega[3], body[3], wanted[3], m[3][3], worst = 0;

	for (int k = 0; k < 3; k++)
		spin[k] = inertia[k] * start[k];
	for (int s = 0; s < steps; s++) {
		ts_rigid_omega(q, inertia, spin, omega);
		ts_rigid_advance_orientation(inertia, spin, omega, t / steps, q);
	}
	ts_rigid_omega(q, inertia, spin, omega);
	ts_quaternion_matrix(q, m);
	ts_rotate_back(m, omega, body);
	exact_omega(start, t, wanted);
	wanted[1] = copysign(wanted[1], body[1]);
	for (int k = 0; k < 3; k++)
		worst = fmax(worst, fabs(body[k] - wanted[k]));
	return worst;
}

START_TEST(free_top)
{
	const double *start = start_of[_i];
	double coarse = error_after(start, 400), fine = error_after(start, 800);

	ck_assert_double_lt(coarse, 3e-4);
	ck_assert_double_gt(log2(coarse / fine), 1.9);
	ck_assert_double_lt(error_after(start, 102400), 5e-9);
}
END_TEST

/* About a principal axis the angle is omega t; about one without inertia nothing turns. */
START_TEST(steady_turning)
{
	const double line[3] = { 2.385, 2.385, 0 };
	const double spin[3] = { 0.7, 0, 0 };
	double q[4] = { 1, 0, 0, 0 }, omega[3];

	ts_rigid_omega(q, line, (double[]){ 0.7, 0, 0.1 }, omega);
	ck_assert_double_eq_tol(omega[0], 0.7 / 2.385, 1e-15);
	ck_assert(omega[1] == 0 && omega[2] == 0);
	for (int s = 0; s < 1000; s++) {
		ts_rigid_omega(q, line, spin, omega);
		ts_rigid_advance_orientation(line, spin, omega, 0.01, q);
	}
	ck_assert_double_eq_tol(2 * atan2(q[1], q[0]), 10 * 0.7 / 2.385, 3e-6);
}
END_TEST

START_TEST(quaternions_and_matrices)
{
	double q[4] = { 0.3, -0.2, 0.9, _i * 0.25 }, again[4], m[3][3], out[3], back[3];
	const double v[3] = { 1.7, -0.3, 2.385 };

	ts_quaternion_normalise(q);
	ts_quaternion_matrix(q, m);
	ts_quaternion_of_matrix(m, again);
	for (int k = 0; k < 4; k++)
		ck_assert_double_eq_tol(again[k] * copysign(1, again[2] * q[2]), q[k], 1e-14);
	ts_rotate(m, v, out);
	ck_assert_double_eq_tol(ts_norm(out), ts_norm(v), 1e-14);
	ts_rotate_back(m, out, back);
	for (int k = 0; k < 3; k++)
		ck_assert_double_eq_tol(back[k], v[k], 1e-14);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("rigid bodies");
	TCase *tests = tcase_create("turning");
	SRunner *runner;
	int failed;

	tcase_add_loop_test(tests, free_top, 0, 2);
	tcase_add_test(tests, steady_turning);
	tcase_add_loop_test(tests, quaternions_and_matrices, -8, 9);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
