/* Speeds and angles of an impact: exact points, no approach, and input that is not a number. */
#include <stdlib.h>

#include "asserts.h"
#include "impact/impact_event.h"
#include "math/constants.h"

/* Normal speed 2 (away if sign is -1) and tangential speed 1.5 at a surface with the normal (2, -3, 6)/7. */
static struct ts_impact_event impact(double sign)
{
	return (struct ts_impact_event){ .mass = 3,
					 .normal = { 2.0 / 7, -3.0 / 7, 6.0 / 7 },
					 .velocity = { (-sign * 4 + 9) / 7, (sign * 6 + 3) / 7,
						       (-sign * 12 - 1.5) / 7 } };
}

START_TEST(components_of_the_velocity)
{
	struct ts_impact_event e = impact(1);
	double along = sqrt(81 + 9 + 2.25) / 7;

	ck_assert_double_eq_tol(ts_impact_normal_speed(&e), 2, 1e-15);
	ck_assert_double_eq_tol(ts_impact_tangential_speed(&e), along, 1e-15);
	ck_assert_double_eq_tol(ts_impact_angle(&e), atan(2 / along), 1e-15);
	ck_assert_double_eq_tol(ts_impact_speed(&e), sqrt(4 + along * along), 1e-15);
	ck_assert_double_eq_tol(ts_impact_energy(&e), 1.5 * (4 + along * along), 1e-14);
}
END_TEST

START_TEST(no_approach)
{
	struct ts_impact_event e = impact(-1), still = { .normal = { 0, 0, 1 } };

	ck_assert(ts_impact_normal_speed(&e) == 0 && !signbit(ts_impact_normal_speed(&e)));
	ck_assert(ts_impact_angle(&e) == 0);
	ck_assert_double_gt(ts_impact_speed(&e), 1);
	ck_assert(ts_impact_normal_speed(&still) == 0 && !signbit(ts_impact_normal_speed(&still)));
	ck_assert(ts_impact_angle(&still) == 0 && ts_impact_energy(&still) == 0);
}
END_TEST

START_TEST(not_a_number_stays_one)
{
	struct ts_impact_event e = impact(1);

	(_i < 3 ? e.velocity : e.normal)[_i % 3] = NAN;
	ck_assert_double_nan(ts_impact_normal_speed(&e));
	ck_assert_double_nan(ts_impact_tangential_speed(&e));
	ck_assert_double_nan(ts_impact_angle(&e));
	ck_assert_double_nan(ts_impact_speed(&e));
	ck_assert_double_nan(ts_impact_energy(&e));
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("impact_event");
	TCase *tests = tcase_create("speeds");
	SRunner *runner;
	int failed;

	tcase_add_test(tests, components_of_the_velocity);
	tcase_add_test(tests, no_approach);
	tcase_add_loop_test(tests, not_a_number_stays_one, 0, 6);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
