/* Steps of the scheme of Prince and Dormand: orders of the state and of the error estimate, coefficients. */
#include <math.h>

#include "asserts.h"
#include "../deck.h"
#include "math/prince_dormand.h"

/* A mass on an orbit of Kepler's problem with eccentricity 0.3: x, y, vx, vy, and a number that does not change. */
static void kepler(const double *y, double *dy, const void *context)
{
	double r = hypot(y[0], y[1]), mu = *(const double *)context;

	dy[0] = y[2];
	dy[1] = y[3];
	dy[2] = -mu * y[0] / (r * r * r);
	dy[3] = -mu * y[1] / (r * r * r);
	dy[4] = 0;
}

enum { N = 5, LEVELS = 4 };

/* The state after half an orbit in steps: the errors of the state and of the estimates, the sum of which is the error of
 * order 7. */
static void half_orbit(int steps, double *state, double *estimate)
{
	const double mu = 1, e = 0.3, pi = 3.14159265358979323846;
	struct ts_prince_dormand s = { .derivative = kepler, .context = &mu, .n = N };
	double y[TS_PRINCE_DORMAND_MOST] = { 1 - e, 0, 0, sqrt((1 + e) / (1 - e)), 42 };
	double error[TS_PRINCE_DORMAND_MOST];

	*estimate = 0;
	for (int k = 0; k < steps; k++) {
		ts_prince_dormand_start(&s, y);
		ts_prince_dormand_step(&s, pi / steps, y, error);
		*estimate = fmax(*estimate, hypot(error[0], error[1]) * steps / pi);
		ck_assert(error[4] == 0 && y[4] == 42);
	}
	*state = hypot(y[0] + 1 + e, y[1]) + hypot(y[2], y[3] + sqrt((1 - e) / (1 + e)));
}

START_TEST(orders)
{
	double h[LEVELS], state[LEVELS], estimate[LEVELS], order;

	for (int k = 0; k < LEVELS; k++) {
		int steps = (int)lround(6 * pow(1.5, k));

		h[k] = 1.0 / steps;
		half_orbit(steps, &state[k], &estimate[k]);
	}
	order = deck_order(h, state, LEVELS);
	ck_assert_msg(order > 7.5, "state of order %g, errors %g to %g", order, state[0], state[LEVELS - 1]);
	order = deck_order(h, estimate, LEVELS);
	ck_assert_msg(order > 6.5 && order < 8.5, "estimate of order %g", order);
}
END_TEST

static void grows(const double *y, double *dy, const void *context)
{
	(void)context;
	for (int k = 0; k < TS_PRINCE_DORMAND_MOST; k++)
		dy[k] = (k + 1) * y[k];
}

/* y' = a y: the step is the series of exp(a h) to order 8, in which terms of higher order are some 1e-8. All numbers of a
 * state are advanced, and steps from one state do not change it. */
START_TEST(series_of_the_exponential)
{
	struct ts_prince_dormand s = { .derivative = grows, .n = TS_PRINCE_DORMAND_MOST };
	double one[TS_PRINCE_DORMAND_MOST], to[TS_PRINCE_DORMAND_MOST], again[TS_PRINCE_DORMAND_MOST];
	double error[TS_PRINCE_DORMAND_MOST];

	for (int k = 0; k < TS_PRINCE_DORMAND_MOST; k++)
		one[k] = 1;
	ts_prince_dormand_start(&s, one);
	ts_prince_dormand_step(&s, 0.01, to, error);
	ts_prince_dormand_step(&s, 0.02, again, error);
	ts_prince_dormand_step(&s, 0.01, again, error);
	for (int k = 0; k < TS_PRINCE_DORMAND_MOST; k++) {
		DECK_NEAR(to[k], exp(0.01 * (k + 1)), 1e-13);
		ck_assert(to[k] == again[k]);
		ck_assert(fabs(error[k]) < 1e-12);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("Prince and Dormand");
	TCase *tc = tcase_create("steps");
	SRunner *runner = srunner_create(suite);
	int failed;

	tcase_add_test(tc, orders);
	tcase_add_test(tc, series_of_the_exponential);
	suite_add_tcase(suite, tc);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed != 0;
}
