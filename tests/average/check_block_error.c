/* Standard errors of correlated samples by blocks, against those known of white noise and of an autoregressive
 * process. */
#include <math.h>
#include <stdlib.h>

#include "asserts.h"
#include "average/block_error.h"

/* Uniform in [-sqrt(3), sqrt(3)): variance 1. */
static double noise(uint64_t *state)
{
	*state = *state * 6364136223846793005u + 1442695040888963407u;
	return sqrt(3) * (2 * (double)(*state >> 11) / 9007199254740992.0 - 1);
}

/* x_t = r x_(t-1) + noise: the variance of the mean of n samples tends to 1/(n (1 - r)^2). */
static void feed(struct ts_blocks *b, double r, int n, uint64_t seed, double slope)
{
	int failures = 0;
	double x = 0;

	for (int t = -200; t < n; t++) {
		double sample[2];

		x = r * x + noise(&seed);
		sample[0] = 1e6 + x + slope * t;
		sample[1] = 2.385;
		if (t >= 0)
			failures += ts_blocks_add(b, sample, 2) != TS_OK;
	}
	ck_assert_int_eq(failures, 0);
}

/* Mean over repeated series of the squared error by blocks, divided by the known variance of the mean. */
static double variance_ratio(double r, int n, double *outside)
{
	double sum = 0, z;
	int repeats = 400;

	*outside = 0;
	for (int k = 0; k < repeats; k++) {
		struct ts_blocks b = { .most = 32 };
		double out[TS_BLOCKS_COLUMNS];

		feed(&b, r, n, (uint64_t)(77 + k), 0);
		ck_assert_int_eq(ts_blocks_samples(&b), n);
		ts_blocks_result(&b, 0, out);
		sum += out[1] * out[1] * n * (1 - r) * (1 - r) / repeats;
		z = (out[0] - 1e6) / out[1];
		*outside += (fabs(z) > 2) / (double)repeats;
		ts_blocks_result(&b, 1, out);
		ck_assert(out[0] == 2.385 && out[1] == 0 && out[2] == 0 && out[3] == 0);
		ts_blocks_release(&b);
	}
	return sum;
}

START_TEST(errors_are_those_of_the_mean)
{
	double outside;

	/* standard error of the ratio: sqrt(2/(16..31)/400) = 0.015 */
	ck_assert_double_eq_tol(variance_ratio(0, 5000, &outside), 1, 0.06);
	ck_assert_double_eq_tol(outside, 0.06, 0.04);
	ck_assert_double_eq_tol(variance_ratio(0.9, 8000, &outside), 1, 0.08);
	ck_assert_double_eq_tol(outside, 0.06, 0.04);
	/* with blocks shorter than the correlation time of 1000 samples it is too small */
	ck_assert_double_lt(variance_ratio(0.999, 4000, &outside), 0.6);
}
END_TEST

START_TEST(drift_is_seen)
{
	int seen = 0, false_alarms = 0;
	double out[TS_BLOCKS_COLUMNS];

	for (int k = 0; k < 100; k++)
		for (int drifts = 0; drifts < 2; drifts++) {
			struct ts_blocks b = { .most = 32 };

			/* halves differ by 0.5 * 20000 * slope = 1; the error of their difference is 0.2 */
			feed(&b, 0.9, 20000, (uint64_t)(9 + k), drifts * 1e-4);
			ts_blocks_result(&b, 0, out);
			*(drifts ? &seen : &false_alarms) += fabs(out[2]) > 3;
			ts_blocks_release(&b);
		}
	ck_assert_int_gt(seen, 90);
	ck_assert_int_lt(false_alarms, 5);
}
END_TEST

START_TEST(correlation_is_that_of_blocks)
{
	struct ts_blocks b = { .most = 4000 };
	double out[TS_BLOCKS_COLUMNS];

	/* blocks of one sample: the correlation of the process; standard error 1/sqrt(3999) = 0.016 */
	feed(&b, 0.5, 3999, 5, 0);
	ts_blocks_result(&b, 0, out);
	ck_assert_double_eq_tol(out[3], 0.5, 0.05);
	ts_blocks_release(&b);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("block_error");
	TCase *tcase = tcase_create("block_error");
	SRunner *runner = srunner_create(suite);
	int failed;

	tcase_add_test(tcase, errors_are_those_of_the_mean);
	tcase_add_test(tcase, drift_is_seen);
	tcase_add_test(tcase, correlation_is_that_of_blocks);
	suite_add_tcase(suite, tcase);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
