/* All pairs within a cutoff, against a search through all images. */
#include <stdlib.h>

#include "asserts.h"
#include "geom/pairs.h"
#include "math/unionfind.h"

enum { POINTS = 41 };

static double x[POINTS][3];
static const double cutoffs[] = { 0.03, 0.2385, 0.5, 1.0, 1.7 };
enum { NCUTOFFS = sizeof cutoffs / sizeof *cutoffs };

/* The same numbers on every machine. */
static double next(uint32_t *state)
{
	*state = *state * 1664525u + 1013904223u;
	return *state / 4294967296.0;
}

static struct ts_box box_of(int periodic)
{
	struct ts_box box = { .lo = { -0.1, 0.2, 0 }, .hi = { 0.9, 1.1, 0.7 } };

	for (int d = 0; d < 3; d++)
		box.face[d][0] = box.face[d][1] = periodic >> d & 1 ? TS_FACE_PERIODIC : TS_FACE_FIXED;
	return box;
}

/* Some points lie a little or a whole box outside. */
static void scatter(const struct ts_box *box)
{
	uint32_t state = 2385;

	for (int i = 0; i < POINTS; i++)
		for (int d = 0; d < 3; d++)
			x[i][d] = box->lo[d] +
				  (1.2 * next(&state) - 0.1 + (i % 13 == 0)) * ts_box_length(box, d);
}

struct found {
	long count[POINTS];
	double sum[3]; /* of d: nothing, as each pair comes from both sides */
};

static void visit(void *context, size_t i, size_t j, const double d[3])
{
	struct found *f = context;

	f->count[i] += 1 + 100 * (long)j;
	for (int k = 0; k < 3; k++)
		f->sum[k] += d[k];
}

static long brute(const struct ts_box *box, double cutoff, int i)
{
	long count = 0;
	int reach[3];

	for (int d = 0; d < 3; d++)
		reach[d] = ts_box_periodic(box, d) ? 6 : 0;
	for (int j = 0; j < POINTS; j++)
		for (int a = -reach[0]; a <= reach[0]; a++)
			for (int b = -reach[1]; b <= reach[1]; b++)
				for (int c = -reach[2]; c <= reach[2]; c++) {
					double u = x[i][0] - x[j][0] - a * ts_box_length(box, 0);
					double v = x[i][1] - x[j][1] - b * ts_box_length(box, 1);
					double w = x[i][2] - x[j][2] - c * ts_box_length(box, 2);

					if ((i != j || a || b || c) &&
					    u * u + v * v + w * w < cutoff * cutoff)
						count += 1 + 100 * j;
				}
	return count;
}

START_TEST(pairs)
{
	struct ts_box box = box_of(_i % 8);
	double cutoff = cutoffs[_i / 8];
	struct found found = { { 0 }, { 0 } };

	scatter(&box);
	ck_assert_int_eq(ts_pairs_visit(&box, 3, (const double(*)[3])x, POINTS, cutoff, visit, &found),
			 TS_OK);
	for (int i = 0; i < POINTS; i++)
		ck_assert_int_eq(found.count[i], brute(&box, cutoff, i));
	for (int k = 0; k < 3; k++)
		ck_assert_double_eq_tol(found.sum[k], 0, 1e-9);
}
END_TEST

START_TEST(few)
{
	struct ts_box box = box_of(0);
	struct found found = { { 0 }, { 0 } };

	ck_assert_int_eq(ts_pairs_visit(&box, 3, NULL, 0, 1, visit, &found), TS_OK);
	x[0][0] = x[0][1] = x[0][2] = 0.3;
	ck_assert_int_eq(ts_pairs_visit(&box, 3, (const double(*)[3])x, 1, 1, visit, &found), TS_OK);
	ck_assert_int_eq(found.count[0], 0);
}
END_TEST

START_TEST(sets)
{
	int32_t parent[6];
	const int32_t key[6] = { 30, 20, 10, 60, 50, 40 };

	ts_sets_start(parent, 6);
	ts_sets_join(parent, key, 0, 1);
	ts_sets_join(parent, key, 3, 4);
	ts_sets_join(parent, key, 1, 2);
	ck_assert_uint_eq(ts_sets_root(parent, 0), 2);
	ck_assert_uint_eq(ts_sets_root(parent, 3), 4);
	ts_sets_join(parent, key, 3, 0);
	for (size_t i = 0; i < 5; i++)
		ck_assert_uint_eq(ts_sets_root(parent, i), 2);
	ck_assert_uint_eq(ts_sets_root(parent, 5), 5);
}
END_TEST

int main(void)
{
	Suite *s = suite_create("pairs");
	TCase *t = tcase_create("pairs");
	SRunner *r;
	int failed;

	tcase_add_loop_test(t, pairs, 0, 8 * NCUTOFFS);
	tcase_add_test(t, few);
	tcase_add_test(t, sets);
	suite_add_tcase(s, t);
	r = srunner_create(s);
	srunner_run_all(r, CK_NORMAL);
	failed = srunner_ntests_failed(r);
	srunner_free(r);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
