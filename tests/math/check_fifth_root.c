/* The fifth root beside exact powers and beside products in extended precision. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "math/fifth_root.h"
#include "math/rng.h"

START_TEST(exact_powers)
{
	for (int k = 1; k < 1000; k++)
		ck_assert_double_eq_tol(ts_fifth_root(pow(k, 5)), k, k * 2.3e-16);
	for (int e = -200; e <= 200; e++)
		ck_assert_double_eq(ts_fifth_root(ldexp(1, 5 * e)), ldexp(1, e));
}
END_TEST

/* y = x^(1/5) (1 + d): y^5/x - 1 is 5 d. */
START_TEST(error_in_units_of_the_last_place)
{
	struct ts_rng rng = ts_rng_start(4711, 0);
	double worst = 0;

	for (int k = 0; k < 400000; k++) {
		double x = ldexp(1 + ts_rng_uniform(&rng), (int)(2000 * ts_rng_uniform(&rng)) - 1000);
		double y = ts_fifth_root(x), unit = nextafter(y, INFINITY) - y;
		long double z = y, error = (z * z * z * z * z / x - 1) / 5;

		worst = fmax(worst, fabs((double)(error * z / unit)));
	}
	ck_assert_double_lt(worst, 1.1);
	ck_assert_double_gt(worst, 0.4);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("fifth root");
	TCase *tests = tcase_create("all");
	SRunner *runner;
	int failed;

	tcase_add_test(tests, exact_powers);
	tcase_add_test(tests, error_in_units_of_the_last_place);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
