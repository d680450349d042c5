/* How ranks wait: the policy, and that a passive rank sleeps. */
#include <stdlib.h>

#include "asserts.h"
#include "base/clock.h"
#include "rank/waiting.h"

static const double nap = 3e-5, longest_nap = 1e-3; /* s */

START_TEST(policy_is_that_of_threads)
{
	static const struct {
		const char *word;
		bool passive;
	} policies[] = {
		{ "passive", true }, { "PASSIVE", true }, { "active", false }, { "", false }, { NULL, false }
	};

	for (size_t k = 0; k < sizeof policies / sizeof *policies; k++)
		ck_assert(ts_waiting_policy(policies[k].word).passive == policies[k].passive);
	ck_assert_int_lt(ts_waiting_policy("passive").polls, ts_waiting_policy(NULL).polls);
}
END_TEST

/* The least time of some offers, s. */
static double offer(struct ts_waiting *w, bool first)
{
	double least = 1;

	for (int k = 0; k < 20; k++) {
		double begin = ts_clock(), took;

		ts_waiting_offer(w, first);
		took = ts_clock() - begin;
		least = took < least ? took : least;
	}
	return least;
}

START_TEST(passive_ranks_sleep)
{
	struct ts_waiting w = { .passive = true };

	ts_waiting_be_exact(&w);
	w.shared_until = ts_clock() + 100; /* others compute */
	ck_assert_double_ge(offer(&w, true), nap);
	w.shared_until = 0;
	ts_waiting_offer(&w, true);
	ck_assert_double_le(ts_clock() - w.begun, 10); /* this wait has just begun */
	w.begun -= 1;				       /* it is long */
	ck_assert_double_ge(offer(&w, false), longest_nap);
}
END_TEST

START_TEST(others_do_not)
{
	struct ts_waiting w = { .shared_until = ts_clock() + 100 };

	offer(&w, true);
	ck_assert(w.begun == 0); /* the clock is not read */
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("rank");
	TCase *tests = tcase_create("waiting");
	SRunner *runner;
	int failed;

	tcase_add_test(tests, policy_is_that_of_threads);
	tcase_add_test(tests, passive_ranks_sleep);
	tcase_add_test(tests, others_do_not);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
