/* Largest stable gains of a servo: law/servo.h beside the loop itself, computed step by step. */
#include <check.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "law/servo.h"

enum { STEPS = 4000000 };
static const double H = 5e-5;

/* Whether the surface comes back, or stays near, after it has been moved by 1. */
static bool comes_back(const struct ts_servo_loop *s, double factor)
{
	double x = 1, v = 0, last = 0, sum = 0;

	for (long n = 0; n < STEPS && fabs(x) < 1e6; n++) {
		double force = s->stiffness * x + s->damping * v;

		sum += force;
		v = -factor * (s->gain[0] * force + s->gain[1] * H * sum + s->gain[2] * (force - last) / H);
		last = force;
		x += v * H;
	}
	return fabs(x) < 1e6;
}

/* Also with small integral gains, where zeros of the polynomial nearly coincide for small factors. */
START_TEST(margins)
{
	static const double gains[][3] = { { 10, 0, 0 }, { 10, 0.5, 0 }, { 10, 0.5, 0.5 }, { 0.1, 20, 0 } };

	for (size_t g = 0; g < sizeof gains / sizeof *gains; g++)
		for (int k = 0; k < 3; k++)
			for (int c = 0; c < 3; c++) {
				const double unit = 0.2 / 500;
				const struct ts_servo_loop s = { 1e5 * pow(10, k),
								 100.0 * c,
								 { unit * gains[g][0], unit * gains[g][1],
								   unit * gains[g][2] } };
				const double margin = ts_servo_margin(&s, H);

				ck_assert_msg(comes_back(&s, 0.95 * margin),
					      "gains %zu, K %g, C %g, %g: diverges", g, s.stiffness,
					      s.damping, margin);
				ck_assert_msg(!comes_back(&s, 1.05 * margin),
					      "gains %zu, K %g, C %g, %g: comes back", g, s.stiffness,
					      s.damping, margin);
			}
}
END_TEST

/* p (K h + 2 C) < 2 */
START_TEST(proportional)
{
	const struct ts_servo_loop s = { 1e6, 10, { 0.004, 0, 0 } };

	ck_assert_double_eq_tol(ts_servo_margin(&s, H), 2 / (0.004 * (1e6 * H + 20)), 1e-4);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("servo");
	TCase *tcase = tcase_create("servo");
	SRunner *runner;
	int failed;

	tcase_set_timeout(tcase, 100);
	tcase_add_test(tcase, margins);
	tcase_add_test(tcase, proportional);
	suite_add_tcase(suite, tcase);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
