/* Tables from files: every allocation may fail, many rows, and what is no table. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "asserts.h"
#include "deck.h"
#include "sheet/sheet_read.h"

/* Writes a file of this process and returns its name. */
static const char *write_file(const char *ending, const char *text)
{
	static char path[64];
	FILE *file;

	snprintf(path, sizeof path, "check_sheet.%ld.%s", (long)getpid(), ending);
	file = fopen(path, "w");
	ck_assert_ptr_nonnull(file);
	ck_assert(fputs(text, file) >= 0);
	fclose(file);
	return path;
}

static enum ts_status read_sheets(struct ts_sheets *t, const char *path, struct ts_error *err)
{
	struct ts_pool *pool = ts_pool_new();
	enum ts_status status = pool ? ts_sheets_read(t, NULL, err, pool, path) : TS_NOMEM;

	ts_pool_free(pool);
	return status;
}

static const char log_text[] =
	"tsim 0\n    Step   a\n   0 1.5\nmessage 3\n  10 nan\n2 3\n 7 8\nLoop time of 1\n"
	"    Step   a   a\n  10  1 2\n12345678 3 4\nLoop time of 1\n";

/* Rows stand in the columns of the first one, and a step may be longer than its column; messages of as many numbers do not. */
static const char columns_text[] = "    Step         KinEng \n"
				   "99999990     1.68861 \n"
				   "100000005 1\n"
				   " 100000005 1.6 \n"
				   "       7     1.68862 \n"
				   "100000010     1.68863 \n"
				   "Loop time of 1\n";

START_TEST(log_with_messages_of_numbers)
{
	const char *path = write_file("log", columns_text);
	struct ts_sheets t = { 0 };
	struct ts_error err = { 0 };

	ck_assert_msg(read_sheets(&t, path, &err) == TS_OK, "%s", err.message);
	remove(path);
	ck_assert_uint_eq(t.n, 1);
	ck_assert_uint_eq(t.sheet[0].rows, 3);
	ck_assert(t.sheet[0].column[0].value[2] == 100000010 && t.sheet[0].column[1].value[2] == 1.68863);
	ts_sheets_release(&t);
}
END_TEST

START_TEST(log_of_two_runs)
{
	const char *path = write_file("log", log_text);
	struct ts_sheets t = { 0 };
	struct ts_error err = { 0 };

	ck_assert_msg(read_sheets(&t, path, &err) == TS_OK, "%s", err.message);
	remove(path);
	ck_assert_int_eq(t.kind, TS_SHEET_LOG);
	ck_assert_uint_eq(t.n, 2);
	ck_assert_uint_eq(t.sheet[0].rows, 2);
	ck_assert_uint_eq(t.sheet[0].columns, 2);
	ck_assert(t.sheet[0].column[0].value[1] == 10 && isnan(t.sheet[0].column[1].value[1]));
	ck_assert_uint_eq(t.sheet[1].rows, 2);
	ck_assert_str_eq(t.sheet[1].column[2].name, "a(2)");
	ck_assert(t.sheet[1].column[0].value[1] == 12345678 && t.sheet[1].column[2].value[1] == 4);
	ck_assert_uint_eq(ts_sheet_find(&t.sheet[1], "a"), 1);
	ck_assert_uint_eq(ts_sheet_find(&t.sheet[1], "3"), 2);
	ck_assert(ts_sheet_find(&t.sheet[1], "4") == SIZE_MAX && ts_sheet_find(&t.sheet[1], "b") == SIZE_MAX);
	ck_assert(!ts_sheet_alike(&t.sheet[0], &t.sheet[1]) && ts_sheet_alike(&t.sheet[1], &t.sheet[1]));
	ts_sheets_release(&t);
}
END_TEST

START_TEST(memory)
{
	static const char *const text[] = {
		log_text,
		"LAMMPS (1)\n---------------- Step 0 ----- CPU = 0 (sec) ----------------\nTemp = 1 \nLoop "
		"time of 1\n",
		"# t (s) v\n0 1\n1 2\n",
		"# TimeStep Number-of-rows\n# Row x\n0 2\n1 5\n2 6\n5 1\n1 7\n",
		"a,\"b, c\"\n1,x\n2,\n",
	};
	const long before = ts_alloc_balance();

	for (size_t f = 0; f < DECK_LENGTH(text); f++) {
		const char *path = write_file("memory", text[f]);

		for (long k = 1;; k++) {
			struct ts_sheets t = { 0 };
			struct ts_error err = { 0 };
			enum ts_status status;

			ts_alloc_fail_at(k);
			status = read_sheets(&t, path, &err);
			ts_alloc_fail_at(0);
			ts_sheets_release(&t);
			ck_assert_int_eq(ts_alloc_balance(), before);
			if (status == TS_OK) {
				ck_assert_int_gt(k, 5);
				break;
			}
			ck_assert_int_eq(status, TS_NOMEM);
		}
		remove(path);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("sheet");
	TCase *tcase = tcase_create("sheet");

	tcase_add_test(tcase, log_with_messages_of_numbers);
	tcase_add_test(tcase, log_of_two_runs);
	tcase_add_test(tcase, memory);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
