/* Rows of a report: every peak remains however many rows are merged, in the order in which they came. */
#include <math.h>
#include <stdlib.h>

#include "asserts.h"
#include "report/rows.h"

#include "deck.h"

START_TEST(few_rows_are_kept_as_they_are)
{
	struct ts_rows rows = { 0 };
	double x[2 * TS_ROWS_MOST], y[2 * TS_ROWS_MOST];

	ck_assert_int_eq(ts_rows_begin(&rows, 2), TS_OK);
	for (int k = 0; k < 100; k++)
		ts_rows_add(&rows, k, (const double[]){ sin(k), 7 });
	ck_assert_uint_eq(ts_rows_curve(&rows, 0, x, y), 100);
	for (int k = 0; k < 100; k++)
		ck_assert(x[k] == k && y[k] == sin(k));
	ck_assert(!ts_rows_is_constant(&rows, 0) && ts_rows_is_constant(&rows, 1));
	ts_rows_release(&rows);
}
END_TEST

START_TEST(peaks_remain)
{
	enum { N = 1000003, PEAK = 123457, DIP = 123459 };
	struct ts_rows rows = { 0 };
	double x[2 * TS_ROWS_MOST], y[2 * TS_ROWS_MOST];
	size_t n, peak = 0, dip = 0;

	ck_assert_int_eq(ts_rows_begin(&rows, 1), TS_OK);
	for (int k = 0; k < N; k++)
		ts_rows_add(&rows, k, (const double[]){ k == PEAK ? 5 : k == DIP ? -5 : sin(1e-5 * k) });
	n = ts_rows_curve(&rows, 0, x, y);
	ck_assert(n > TS_ROWS_MOST / 2 && n <= 2 * TS_ROWS_MOST);
	ck_assert_int_eq(rows.count, N);
	for (size_t k = 0; k < n; k++) {
		ck_assert(k == 0 || x[k] >= x[k - 1]);
		peak = y[k] == 5 ? k : peak;
		dip = y[k] == -5 ? k : dip;
	}
	ck_assert(peak > 0 && dip == peak + 1); /* in the order in which they came */
	ck_assert(fabs(x[peak] - PEAK) <= (double)rows.each && x[n - 1] == N - 1);
	ck_assert(rows.sum[0].first == 0 && rows.sum[0].greatest == 5 && rows.sum[0].least == -5);
	ts_rows_release(&rows);
}
END_TEST

START_TEST(odd_numbers_are_gaps)
{
	struct ts_rows rows = { 0 };
	double x[2 * TS_ROWS_MOST], y[2 * TS_ROWS_MOST];

	ck_assert_int_eq(ts_rows_begin(&rows, 1), TS_OK);
	ts_rows_add(&rows, 0, (const double[]){ 1 });
	ts_rows_add(&rows, 1, (const double[]){ INFINITY });
	ts_rows_add(&rows, 2, (const double[]){ 2 });
	ck_assert_uint_eq(ts_rows_curve(&rows, 0, x, y), 3);
	ck_assert(y[0] == 1 && isnan(y[1]) && y[2] == 2);
	ck_assert(rows.sum[0].finite == 2 && rows.sum[0].odd == 1);
	ts_rows_release(&rows);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("rows of a report");
	TCase *tests = tcase_create("rows");

	tcase_add_test(tests, few_rows_are_kept_as_they_are);
	tcase_add_test(tests, peaks_remain);
	tcase_add_test(tests, odd_numbers_are_gaps);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
