/* The law of wear: closed forms, and that its two branches meet. */
#include <stdlib.h>

#include "asserts.h"
#include "law/contact_wear.h"

START_TEST(branches_meet)
{
	double g = atan(1.0 / 3);

	ck_assert_double_eq_tol(ts_wear_angle(sin(g) * (1 + 1e-12), cos(g)),
				ts_wear_angle(sin(g) * (1 - 1e-12), cos(g)), 1e-5);
	/* at most at half of tan 2g = 2/3 */
	g = 0.5 * atan(2.0 / 3);
	ck_assert_double_gt(ts_wear_angle(sin(g), cos(g)), ts_wear_angle(sin(g + 0.01), cos(g + 0.01)));
	ck_assert_double_gt(ts_wear_angle(sin(g), cos(g)), ts_wear_angle(sin(g - 0.01), cos(g - 0.01)));
}
END_TEST

START_TEST(known_angles)
{
	const double normal[3] = { 0, 0, 1 };
	const double steep[3] = { 0.3, 0, -0.4 }, flat[3] = { 2.385, 0, -0.2385 }, straight[3] = { 0, 0, -7 };
	const double resting[3] = { 0, 0, 0 }, slow[3] = { 0.3e-12, 0, -0.4e-12 },
		     turned[3] = { 0, 0.3, 0.4 };

	/* 2 k v F f h / A with v = 0.5 and f = 0.33333 * 0.6^2 */
	ck_assert_double_eq_tol(ts_wear_finnie(1.7, steep, normal, 31, 0.35, 1e-3),
				2 * 1.7 * 0.5 * 31 * 0.33333 * 0.36 * 1e-3 / 0.35, 1e-15);
	/* tan g = 0.1: f = (0.2 - 0.03) / 1.01 */
	ck_assert_double_eq_tol(ts_wear_finnie(1.7, flat, normal, 31, 0.35, 1e-3),
				2 * 1.7 * 2.385 * sqrt(1.01) * 31 * (0.17 / 1.01) * 1e-3 / 0.35, 1e-13);
	ck_assert_double_eq(ts_wear_finnie(1.7, straight, normal, 31, 0.35, 1e-3), 0);
	ck_assert_double_eq(ts_wear_finnie(1.7, resting, normal, 31, 0.35, 1e-3), 0);
	/* in proportion to the speed, however slow */
	ck_assert_double_eq_tol(1e12 * ts_wear_finnie(1.7, slow, normal, 31, 0.35, 1e-3),
				ts_wear_finnie(1.7, steep, normal, 31, 0.35, 1e-3), 1e-15);
	/* neither the side nor the direction along the surface counts */
	ck_assert_double_eq_tol(ts_wear_finnie(1.7, turned, normal, 31, 0.35, 1e-3),
				ts_wear_finnie(1.7, steep, normal, 31, 0.35, 1e-3), 1e-16);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("wear");
	TCase *tests = tcase_create("wear");
	SRunner *runner;
	int failed;

	tcase_add_test(tests, branches_meet);
	tcase_add_test(tests, known_angles);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
