/* Successive over-relaxation: for which factors it converges, which is the best, and how fast it is,
 * beside theory (D. M. Young, Trans. AMS 76 (1954) 92; W. Kahan, 1958).
 *
 * TS_TABLE=FILE appends what is measured. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "math/rng.h"
#include "poisson/relaxation.h"

enum { N = 17, M = 12 };
static const double PI = 3.14159265358979323846;

struct square {
	struct ts_grid grid;
	struct ts_poisson problem;
	struct ts_stencil stencil;
	double *p, *b, *spare;
};

/* N by M cells; pressure given at all faces, so that no mode is constant. */
static void make(struct square *q, enum ts_pressure_condition condition)
{
	double face[3][N + 1];
	const double *const faces[3] = { face[0], face[1], face[2] };

	*q = (struct square){ .problem.threads = 1 };
	for (int i = 0; i <= N; i++) {
		face[0][i] = 0.385 + 1.3 * i / N;
		face[1][i] = 2.0 * i / N;
		face[2][i] = i;
	}
	ck_assert(ts_grid_make(&q->grid, 2, (int[3]){ N, M, 1 }, faces, (bool[3]){ false }) == TS_OK);
	q->problem.grid = &q->grid;
	for (int d = 0; d < 3; d++)
		for (int side = 0; side < 2; side++)
			q->problem.condition[d][side] = d == 2 ? TS_PRESSURE_NO_GRADIENT : condition;
	q->problem.singular = condition == TS_PRESSURE_NO_GRADIENT;
	ck_assert(ts_stencil_make(&q->stencil, &q->problem) == TS_OK);
	ts_stencil_set_weights(&q->stencil, &q->problem);
	q->p = ts_stencil_field(&q->stencil);
	q->b = ts_stencil_field(&q->stencil);
	q->spare = ts_stencil_field(&q->stencil);
}

static void done(struct square *q)
{
	ts_stencil_field_free(q->p);
	ts_stencil_field_free(q->b);
	ts_stencil_field_free(q->spare);
	ts_stencil_release(&q->stencil);
	ts_grid_release(&q->grid);
}

/* The size of the error of A p = 0 after so many iterations from noise; in a singular system without its
 * mean. */
static double after(struct square *q, double omega, int iterations)
{
	struct ts_rng rng = ts_rng_start(86028157, 1);

	memset(q->p, 0, q->stencil.size * sizeof *q->p);
	for (int j = 0; j < M; j++)
		for (int i = 0; i < N; i++)
			q->p[ts_stencil_at(&q->stencil, i, j, 0)] = ts_rng_uniform(&rng) - 0.5;
	for (int k = 0; k < iterations; k++) {
		ts_stencil_sweep(&q->stencil, q->p, q->b, 0, omega);
		ts_stencil_sweep(&q->stencil, q->p, q->b, 1, omega);
	}
	if (q->problem.singular)
		ts_stencil_centre(&q->stencil, q->p);
	return sqrt(ts_stencil_dot(&q->stencil, q->p, q->p));
}

/* By what an iteration reduces the error in the long run. */
static double factor(struct square *q, double omega)
{
	return pow(after(q, omega, 120) / after(q, omega, 60), 1.0 / 60);
}

static double limit(struct square *q, double converges, double diverges)
{
	while (fabs(diverges - converges) > 2e-4) {
		double omega = 0.5 * (converges + diverges);

		*(after(q, omega, 3000) <= 0.5 * after(q, omega, 600) ? &converges : &diverges) = omega;
	}
	return 0.5 * (converges + diverges);
}

/* The radius of Jacobi's iteration, to which the best factor belongs. */
static double radius(double a, double b)
{
	double x = N / 1.3, y = N / 2.0;

	return 1 - (pow(2 * x * sin(a / 2), 2) + pow(2 * y * sin(b / 2), 2)) / (2 * x * x + 2 * y * y);
}

START_TEST(converges_between_0_and_2)
{
	const char *name = getenv("TS_TABLE");
	FILE *table = name ? fopen(name, "a") : NULL;
	struct square q;
	double low, high;

	make(&q, TS_PRESSURE_GIVEN);
	high = limit(&q, 1.5, 2.6);
	low = limit(&q, 0.3, -0.7);
	ck_assert_double_eq_tol(high, 2, 0.002);
	ck_assert_double_eq_tol(low, 0, 0.002);
	if (table) {
		fprintf(table, "relaxation, upper limit  %8.5f  theory 2\n", high);
		fprintf(table, "relaxation, lower limit  %8.5f  theory 0\n", low);
		fclose(table);
	}
	done(&q);
}
END_TEST

/* Beyond the best factor the error falls by omega - 1, below it more slowly than there. */
START_TEST(best_factor)
{
	const double angle[2][2] = { { PI / N, PI / M }, { PI / N, 0 } };
	const enum ts_pressure_condition condition[2] = { TS_PRESSURE_GIVEN, TS_PRESSURE_NO_GRADIENT };
	struct square q;
	double rho = radius(angle[_i][0], angle[_i][1]), theory, best;

	if (_i == 1) /* the slowest of the modes that are not constant */
		rho = fmax(rho, radius(0, PI / M));
	theory = 2 / (1 + sqrt(1 - rho * rho));
	make(&q, condition[_i]);
	best = ts_relaxation_optimal(&q.problem);
	ck_assert_double_eq_tol(best, theory, 1e-12);
	ck_assert_double_eq_tol(factor(&q, best + 0.05), best + 0.05 - 1, 0.01);
	ck_assert_double_gt(factor(&q, best - 0.05), factor(&q, best + 0.01));
	/* Gauss-Seidel: the square of Jacobi's, but for the cells at the faces, which count as all others
	 * in theory */
	ck_assert_double_eq_tol(factor(&q, 1), rho * rho, 5e-3);
	done(&q);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("stability");
	TCase *tests = tcase_create("over-relaxation");
	SRunner *runner;
	int failed;

	tcase_add_test(tests, converges_between_0_and_2);
	tcase_add_loop_test(tests, best_factor, 0, 2);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
