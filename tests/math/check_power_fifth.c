/* The power of 0.2 beside products in extended precision. */
#include <math.h>
#include <stdlib.h>

#include "asserts.h"
#include "math/power_fifth.h"
#include "math/rng.h"

/* Against the product of five factors in extended precision: y = x^0.2 (1 + d), and y^5 = x x^(5 excess) (1 + 5 d). */
START_TEST(error_in_units_of_the_last_place)
{
	const long double excess = 0.2 - 0.2L;
	struct ts_rng rng = ts_rng_start(4711, 0);
	double worst = 0;

	for (int k = 0; k < 400000; k++) {
		double x = ldexp(1 + ts_rng_uniform(&rng), (int)(1500 * ts_rng_uniform(&rng)) - 750);
		double y = ts_power_fifth(x), unit = nextafter(y, INFINITY) - y;
		long double z = y, error = (z * z * z * z * z / x - 1) / 5 - excess * logl(x);

		worst = fmax(worst, fabs((double)(error * z / unit)));
	}
	ck_assert_double_lt(worst, 0.52);
	ck_assert_double_gt(worst, 0.49);
}
END_TEST

START_TEST(powers_of_two_and_of_whole_numbers)
{
	for (int k = 1; k < 1000; k++)
		ck_assert_double_eq_tol(ts_power_fifth((double)k * k * k * k * k), k, k * 1e-15);
	ck_assert_double_eq(ts_power_fifth(1), 1);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("power of 0.2");
	TCase *tests = tcase_create("all");
	SRunner *runner;
	int failed;

	tcase_add_test(tests, powers_of_two_and_of_whole_numbers);
	tcase_add_test(tests, error_in_units_of_the_last_place);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
