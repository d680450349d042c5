/* Matrices of secants and steps: exact for linear functions, bounds, ranks. */
#include <math.h>
#include <stdlib.h>

#include "asserts.h"
#include "study/secant.h"

/* f = J x */
static const double exact[] = { 0.9, 0.1, 0.0, -0.05, 0.5, 0.385 };

static void multiply(const double *jacobian, size_t rows, size_t n, const double *x, double *f)
{
	for (size_t k = 0; k < rows; k++) {
		f[k] = 0;
		for (size_t j = 0; j < n; j++)
			f[k] += jacobian[k * n + j] * x[j];
	}
}

START_TEST(matrix_of_linear_functions)
{
	struct ts_secant_pair pair[5] = { { .dx = { 0.15 } },
					  { .dx = { 0, -0.15 } },
					  { .dx = { 0, 0, 0.15 } },
					  { .dx = { 1.2, -0.385, 2.1 } },
					  { .dx = { 0.01, 0.02, -0.01 } } };
	double df[10], found[6] = { 0 };

	for (int i = 0; i < 5; i++) {
		multiply(exact, 2, 3, pair[i].dx, &df[2 * i]);
		pair[i].df = &df[2 * i];
	}
	ck_assert_int_eq(ts_secant_jacobian(pair, 5, 3, 2, 0.01, false, found), TS_OK);
	for (int k = 0; k < 6; k++)
		ck_assert_double_eq_tol(found[k], exact[k], 1e-13);
	/* the ridge leaves a right matrix as it is */
	ck_assert_int_eq(ts_secant_jacobian(pair, 2, 3, 2, 0.01, true, found), TS_OK);
	for (int k = 0; k < 6; k++)
		ck_assert_double_eq_tol(found[k], exact[k], 1e-13);
	/* two pairs do not determine three columns, nor do three in one plane */
	ck_assert_int_eq(ts_secant_jacobian(pair, 2, 3, 2, 0.01, false, found), TS_RANGE);
	pair[2] = pair[1];
	ck_assert_int_eq(ts_secant_jacobian(pair, 3, 3, 2, 0.01, false, found), TS_RANGE);
}
END_TEST

/* A curved function: the slope at 0 of exp(x) - 1 by pairs at h and -h/2; an error proportional to h. */
START_TEST(matrix_of_a_curve)
{
	double error[2];

	for (int k = 0; k < 2; k++) {
		double h = k ? 0.03 : 0.06, df[2] = { expm1(h), expm1(-h / 2) }, slope = 0;
		struct ts_secant_pair pair[2] = { { { h }, &df[0] }, { { -h / 2 }, &df[1] } };

		ck_assert_int_eq(ts_secant_jacobian(pair, 2, 1, 1, 1e-6, false, &slope), TS_OK);
		error[k] = fabs(slope - 1);
	}
	ck_assert_double_eq_tol(log2(error[0] / error[1]), 1, 0.05);
	ck_assert_double_lt(error[1], 0.01);
}
END_TEST

START_TEST(step_to_the_solution)
{
	const double jacobian[] = { 0.9, 0.1, -0.05, 0.5 }, wanted[] = { 0.7, -0.385 }, far[] = { 9, 9 },
		     near[] = { -9, -9 }, tolerance[] = { 0.05, 0.01 };
	double f[2], dx[2], left;

	multiply(jacobian, 2, 2, wanted, f);
	f[0] = -f[0];
	f[1] = -f[1];
	ck_assert_int_eq(ts_secant_step(2, 2, jacobian, f, tolerance, near, far, dx, &left), TS_OK);
	for (int j = 0; j < 2; j++)
		ck_assert_double_eq_tol(dx[j], wanted[j], 1e-13);
	ck_assert_double_lt(left, 1e-11);
}
END_TEST

/* The least of (x + 10 y - 12)^2 + (y - 2 x)^2 with x <= 0.2: x = 0.2, 10 (x + 10 y - 12) + y - 2 x = 0. Free, x is 12/21.
 * Clipping the free solution would leave y = 24/21. */
START_TEST(step_at_a_bound)
{
	const double jacobian[] = { 1, 10, -2, 1 }, f[] = { -12, 0 }, tolerance[] = { 1, 1 },
		     lo[] = { -5, -5 }, hi[] = { 0.2, 5 };
	double dx[2], left, y = (118.0 + 0.4) / 101;

	ck_assert_int_eq(ts_secant_step(2, 2, jacobian, f, tolerance, lo, hi, dx, &left), TS_OK);
	ck_assert_double_eq_tol(dx[0], 0.2, 1e-14);
	ck_assert_double_eq_tol(dx[1], y, 1e-12);
	ck_assert_double_eq_tol(left, hypot(0.2 + 10 * y - 12, y - 0.4), 1e-12);
}
END_TEST

/* No step is shorter than that along the gradient; equal columns share it. */
START_TEST(shortest_step)
{
	const double jacobian[] = { 1, 1, 0 }, f[] = { -1 }, tolerance[] = { 1 }, lo[] = { -9, -9, -9 },
		     hi[] = { 9, 9, 9 };
	double dx[3], left;

	ck_assert_int_eq(ts_secant_step(3, 1, jacobian, f, tolerance, lo, hi, dx, &left), TS_OK);
	ck_assert_double_eq_tol(dx[0], 0.5, 1e-12);
	ck_assert_double_eq_tol(dx[1], 0.5, 1e-12);
	ck_assert_double_eq_tol(dx[2], 0, 1e-12);
	ck_assert_double_lt(left, 1e-12);
}
END_TEST

/* The residual of contradicting targets, in units of the tolerances: x = 1 within 0.1 and x = 2 within 0.2. */
START_TEST(contradiction)
{
	const double jacobian[] = { 1, 1 }, f[] = { -1, -2 }, tolerance[] = { 0.1, 0.2 }, lo[] = { -9 },
		     hi[] = { 9 };
	double dx[1], left;

	ck_assert_int_eq(ts_secant_step(1, 2, jacobian, f, tolerance, lo, hi, dx, &left), TS_OK);
	ck_assert_double_eq_tol(dx[0], 1.2, 1e-12); /* (1/0.01 + 2/0.04)/(1/0.01 + 1/0.04) */
	ck_assert_double_eq_tol(left, hypot(2, 4), 1e-12);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("secant");
	TCase *tests = tcase_create("secant");
	SRunner *runner;
	int failed;

	tcase_add_test(tests, matrix_of_linear_functions);
	tcase_add_test(tests, matrix_of_a_curve);
	tcase_add_test(tests, step_to_the_solution);
	tcase_add_test(tests, step_at_a_bound);
	tcase_add_test(tests, shortest_step);
	tcase_add_test(tests, contradiction);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
