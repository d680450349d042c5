/* The text of the progress line; when a log shows it. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "base/log.h"
#include "thermo/progress.h"

static const char *duration(double seconds)
{
	static char text[48];

	ts_progress_duration(seconds, text, sizeof text);
	return text;
}

START_TEST(durations)
{
	ck_assert_str_eq(duration(0), "0 s");
	ck_assert_str_eq(duration(59.9), "59 s");
	ck_assert_str_eq(duration(60), "1 min 0 s");
	ck_assert_str_eq(duration(725.4), "12 min 5 s");
	ck_assert_str_eq(duration(3600 * 3 + 20 * 60 + 59), "3 h 20 min");
	ck_assert_str_eq(duration(86400 * 2 + 3600 * 3.5), "2 d 3 h");
	ck_assert_str_eq(duration(INFINITY), "very long");
	ck_assert_str_eq(duration(NAN), "very long");
}
END_TEST

static const char *line(struct ts_progress_facts facts, int width)
{
	static char text[300];

	ts_progress_line(&facts, width, text, sizeof text);
	ck_assert_int_le((int)strlen(text), width);
	return text;
}

START_TEST(lines)
{
	struct ts_progress_facts f = { 1000, 3500, 11000, 2385.4, 14112, 75 };

	ck_assert_str_eq(line(f, 100), "25.0 %, step 3500 of 11000, 2.39 k steps/s, 33.7 M particle-steps/s, "
				       "1 min 15 s left");
	ck_assert_str_eq(line(f, 80), "25.0 %, step 3500 of 11000, 2.39 k steps/s, 1 min 15 s left");
	ck_assert_str_eq(line(f, 59), "25.0 %, step 3500 of 11000, 2.39 k steps/s, 1 min 15 s left");
	ck_assert_str_eq(line(f, 58), "25.0 %, 2.39 k steps/s, 1 min 15 s left");
	ck_assert_str_eq(line(f, 30), "25.0 %, 1 min 15 s left");
	ck_assert_str_eq(line(f, 15), "1 min 15 s left");
	ck_assert_str_eq(line(f, 3), "");
	f.particles = 0;
	f.steps_per_second = NAN;
	f.left = -1;
	ck_assert_str_eq(line(f, 100), "25.0 %, step 3500 of 11000");
	f.last = 0;
	f.steps_per_second = 0.21;
	ck_assert_str_eq(line(f, 100), "step 3500, 0.21 steps/s");
}
END_TEST

START_TEST(shown_in_silence)
{
	struct ts_log log = { .screen = tmpfile(), .progress = true, .patience = 10 };

	ck_assert_ptr_nonnull(log.screen);
	ts_log(&log, "a row\n");
	ck_assert(!ts_log_shows_progress(&log));
	log.spoke -= 9;
	ck_assert(!ts_log_shows_progress(&log));
	log.spoke -= 1.5;
	ck_assert(ts_log_shows_progress(&log));
	ts_log(&log, "a row, more than ten seconds later\n");
	ts_log(&log, "and another at the same time\n");
	ck_assert(ts_log_shows_progress(&log)); /* at once: the next row is far */
	log.spoke -= 5;
	ts_log(&log, "a row, five seconds later\n");
	ck_assert(!ts_log_shows_progress(&log));
	log.spoke -= 20;
	log.progress = false;
	ck_assert(!ts_log_shows_progress(&log));
	fclose(log.screen);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("progress");
	TCase *tests = tcase_create("progress");
	SRunner *runner;

	tcase_add_test(tests, durations);
	tcase_add_test(tests, lines);
	tcase_add_test(tests, shown_in_silence);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	return srunner_ntests_failed(runner) ? EXIT_FAILURE : EXIT_SUCCESS;
}
