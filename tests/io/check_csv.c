/* Cells of comma-separated values; tables that are begun, appended to, and cut off. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "asserts.h"
#include "core/life.h"
#include "io/csv.h"
#include "library/tsim_tables.h"

static char folder[] = "/tmp/check_csv.XXXXXX", path[64];
static struct tsim *sim;
static struct ts_str row;

static void set_up(void)
{
	sim = ts_sim_new(&ts_tables);
	ck_assert_ptr_nonnull(sim);
}

static void tear_down(void)
{
	ts_str_release(&row);
	ts_sim_free(sim);
}

static const char *real(double value)
{
	ts_str_clear(&row);
	ts_csv_real(&row, value);
	return ts_str_text(&row);
}

START_TEST(numbers)
{
	static const double values[] = { 0.1,	    1.0 / 3,  -2.385,	DBL_MAX, DBL_MIN,  4.9e-324,
					 1 + 1e-15, 123456.7, 1e15 + 2, 1e22,	 0.1 + 0.2 };

	ck_assert_str_eq(real(0.1), "0.1");
	ck_assert_str_eq(real(-3), "-3");
	ck_assert_str_eq(real(0), "0");
	ck_assert_str_eq(real(-0.0), "-0");
	ck_assert_str_eq(real(0.1 + 0.2), "0.30000000000000004");
	ck_assert_str_eq(real(NAN), "nan");
	ck_assert_str_eq(real(-NAN), "nan");
	ck_assert_str_eq(real(INFINITY), "inf");
	ck_assert_str_eq(real(-INFINITY), "-inf");
	for (size_t k = 0; k < sizeof values / sizeof *values; k++)
		ck_assert(strtod(real(values[k]), NULL) == values[k]);
	for (int k = 0; k < 20000; k++) {
		double value = ldexp(drand48() - 0.5, k % 600 - 300);

		if (strtod(real(value), NULL) != value)
			ck_abort_msg("%.17g", value);
	}
}
END_TEST

START_TEST(texts)
{
	static const char *const names[] = { "c_p[1]", "v_a" };

	ts_str_clear(&row);
	ts_csv_names(&row, names, 2);
	ts_csv_text(&row, "a,b");
	ts_csv_text(&row, "say \"no\"");
	ts_csv_text(&row, " blank");
	ts_csv_text(&row, "in between");
	ts_csv_text(&row, "");
	ts_csv_end(&row);
	ts_csv_text(&row, "");
	ts_csv_int(&row, INT64_MIN);
	ts_csv_end(&row);
	ck_assert_str_eq(ts_str_text(&row),
			 "c_p[1],v_a,\"a,b\",\"say \"\"no\"\"\",\" blank\",in between,\"\"\n"
			 "\"\",-9223372036854775808\n");
}
END_TEST

static void begin(struct ts_textfile *file, bool append, const char *name, enum ts_status expected)
{
	struct ts_str names = { 0 };

	ck_assert_int_eq(ts_textfile_open(file, sim, NULL, path, append), TS_OK);
	ts_csv_text(&names, "step");
	ts_csv_text(&names, name);
	ts_csv_end(&names);
	ck_assert_int_eq(ts_csv_begin(file, sim, &names), expected);
	ck_assert_uint_eq(names.length, 0);
}

static void write_row(struct ts_textfile *file, int64_t step, double value)
{
	ts_str_clear(&row);
	ts_csv_int(&row, step);
	ts_csv_real(&row, value);
	ts_csv_end(&row);
	ck_assert_int_eq(ts_csv_write(file, sim, &row), TS_OK);
	ck_assert_int_eq(ts_textfile_close(file), TS_OK);
}

static void holds(const char *text)
{
	char got[200] = "";
	FILE *file = fopen(path, "r");

	ck_assert_ptr_nonnull(file);
	ck_assert_uint_lt(fread(got, 1, sizeof got - 1, file), sizeof got - 1);
	fclose(file);
	ck_assert_str_eq(got, text);
}

START_TEST(appended)
{
	struct ts_textfile file = { 0 };
	FILE *torn;

	snprintf(path, sizeof path, "%s/a.csv", folder);
	begin(&file, true, "v_a", TS_OK); /* the file does not exist */
	write_row(&file, 0, 0.5);
	begin(&file, true, "v_a", TS_OK);
	write_row(&file, 100, 1.5);
	holds("step,v_a\n0,0.5\n100,1.5\n");
	torn = fopen(path, "a");
	ck_assert_ptr_nonnull(torn);
	fputs("200,2.", torn); /* a run that was killed */
	fclose(torn);
	begin(&file, true, "v_a", TS_OK);
	write_row(&file, 300, 3.5);
	holds("step,v_a\n0,0.5\n100,1.5\n300,3.5\n");
	begin(&file, true, "v_b", TS_STATE);
	ck_assert_ptr_nonnull(
		strstr(sim->error.message, "which begins with 'step,v_a': the columns would be 'step,v_b'"));
	ts_textfile_close(&file);
	begin(&file, false, "v_b", TS_OK);
	write_row(&file, 0, 1);
	holds("step,v_b\n0,1\n");
}
END_TEST

START_TEST(appended_gz)
{
	struct ts_textfile file = { 0 };

	snprintf(path, sizeof path, "%s/a.csv.gz", folder);
	begin(&file, false, "v_a", TS_OK);
	write_row(&file, 0, 0.5);
	begin(&file, true, "v_a", TS_OK);
	write_row(&file, 1, 0.5);
	begin(&file, true, "v_b", TS_STATE);
	ts_textfile_close(&file);
}
END_TEST

START_TEST(recognized)
{
	ck_assert(ts_csv_is("a.csv") && ts_csv_is("b/a.*.csv.gz") && ts_csv_is(".csv"));
	ck_assert(!ts_csv_is("a.csv.txt") && !ts_csv_is("csv") && !ts_csv_is(NULL) && !ts_csv_is(""));
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("csv");
	TCase *tests = tcase_create("csv");
	SRunner *runner;
	char command[80];
	int failed;

	if (!mkdtemp(folder))
		return EXIT_FAILURE;
	tcase_add_checked_fixture(tests, set_up, tear_down);
	tcase_add_test(tests, numbers);
	tcase_add_test(tests, texts);
	tcase_add_test(tests, appended);
	tcase_add_test(tests, appended_gz);
	tcase_add_test(tests, recognized);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	snprintf(command, sizeof command, "rm -rf '%s'", folder);
	return system(command) || failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
