#include "script_case.h"

#include <stdio.h>
#include <unistd.h>

struct tsim *sim;
static char *shown;
static size_t shown_size;
static FILE *screen;
static char directory[64], old_directory[1024];

void case_setup(void)
{
	sim = tsim_open();
	ck_assert_ptr_nonnull(sim);
	screen = open_memstream(&shown, &shown_size);
	ck_assert_ptr_nonnull(screen);
	tsim_screen(sim, screen);
}

void case_teardown(void)
{
	tsim_close(sim);
	fclose(screen);
	free(shown);
	ck_assert_int_eq(ts_alloc_balance(), 0);
}

void expect_output(const char *script, const char *output)
{
	rewind(screen);
	ck_assert_msg(tsim_string(sim, script) == 0, "%s", tsim_error(sim));
	fflush(screen);
	ck_assert_msg(shown_size == strlen(output) && memcmp(shown, output, shown_size) == 0,
		      "'%s' prints '%.*s', not '%s'", script, (int)shown_size, shown, output);
}

void expect_error(const char *script, int line, int column, int length, const char *message)
{
	ck_assert_msg(tsim_string(sim, script) != 0, "no error: %s", script);
	ck_assert_msg(strstr(sim->error.message, message) != NULL, "'%s' gives: %s", script,
		      sim->error.message);
	ck_assert_msg(sim->error.place.line == line && sim->error.place.column == column &&
			      sim->error.place.length == length,
		      "'%s' points to %d:%d+%d: %s", script, sim->error.place.line, sim->error.place.column,
		      sim->error.place.length, sim->error.message);
	tsim_error_clear(sim);
}

double value(const char *formula)
{
	double out = NAN;

	ck_assert_msg(tsim_value(sim, formula, &out) == 0, "%s", tsim_error(sim));
	return out;
}

void expect_value(const char *formula, double wanted)
{
	double got = value(formula);

	ck_assert_msg(fabs(got - wanted) <= 1e-15 * fabs(wanted), "%s is %.17g, not %.17g", formula, got,
		      wanted);
}

void write_file(const char *path, const char *text)
{
	FILE *file = fopen(path, "w");

	ck_assert_ptr_nonnull(file);
	fputs(text, file);
	fclose(file);
}

void enter_directory(void)
{
	snprintf(directory, sizeof directory, "/tmp/tsim-check-XXXXXX");
	ck_assert_ptr_nonnull(getcwd(old_directory, sizeof old_directory));
	ck_assert_ptr_nonnull(mkdtemp(directory));
	ck_assert_int_eq(chdir(directory), 0);
}

void leave_directory(void)
{
	ck_assert_int_eq(chdir(old_directory), 0);
	ck_assert_int_eq(rmdir(directory), 0);
}

int case_main(const char *name, void (*add)(TCase *))
{
	Suite *suite = suite_create(name);
	TCase *all = tcase_create(name);
	SRunner *runner;
	int failed;

	tcase_add_checked_fixture(all, case_setup, case_teardown);
	tcase_set_timeout(all, 120);
	add(all);
	suite_add_tcase(suite, all);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
