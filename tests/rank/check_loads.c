/* Loads of ranks: the imbalance, cuts that are shifted, and recursive bisection. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "math/rng.h"
#include "rank/loads.h"

enum { POINTS = 3000 };

static const double lo[3] = { -1, 0, 2 }, hi[3] = { 1, 3, 6 };
static const bool open_faces[3] = { false, false, false }, mixed[3] = { true, false, true };

/* Points in one half of the box, denser at one of its ends. */
static void fill(double (*x)[3], int n)
{
	struct ts_rng rng = ts_rng_start(4711, 0);

	for (int k = 0; k < n; k++) {
		x[k][0] = lo[0] + (hi[0] - lo[0]) / 2 * ts_rng_uniform(&rng);
		x[k][1] = lo[1] + (hi[1] - lo[1]) * pow(ts_rng_uniform(&rng), 3);
		x[k][2] = lo[2] + (hi[2] - lo[2]) * ts_rng_uniform(&rng);
	}
}

START_TEST(imbalance_is_the_largest_load_by_the_mean)
{
	static const int count[3] = { 2, 1, 2 };
	double x[4][3] = { { -0.5, 1, 3 }, { -0.5, 1, 3 }, { -0.5, 1, 5 }, { 0.5, 1, 5 } };
	int64_t weight[4] = { 1, 2, 3, 6 };
	struct ts_rank_blocks blocks = { .count = { 0 } };
	struct ts_rank_points points = { .x = x, .n = 4 };
	struct ts_rank_load load;

	ck_assert(ts_rank_blocks_cut(&blocks, count, lo, hi, open_faces));
	ck_assert_int_eq(ts_rank_load_find(&blocks, &points, &load), TS_OK);
	ck_assert(load.total == 4 && load.most == 2 && load.imbalance == 2);
	points.weight = weight;
	ck_assert_int_eq(ts_rank_load_find(&blocks, &points, &load), TS_OK);
	ck_assert(load.total == 12 && load.most == 6 && load.imbalance == 2);
	points.n = 0;
	ck_assert_int_eq(ts_rank_load_find(&blocks, &points, &load), TS_OK);
	ck_assert(load.total == 0 && load.most == 0 && load.imbalance == 1);
	ts_rank_blocks_release(&blocks);
}
END_TEST

/* Points at (k + 1/2)/n of the length: each cut is known. Only cuts along the dimension named move, in all slabs alike. */
START_TEST(shifted_cuts_divide_the_load)
{
	static const int count[3] = { 4, 2, 3 };
	static double x[POINTS][3];
	struct ts_rank_blocks blocks = { .count = { 0 } };
	struct ts_rank_points points = { .x = x, .n = POINTS };
	int iterations = 0, k[3] = { 0 };

	for (int i = 0; i < POINTS; i++) {
		x[i][0] = lo[0] + (i + 0.5) / POINTS * (hi[0] - lo[0]) / 2;
		x[i][1] = lo[1] + (i + 0.5) / POINTS;
		x[i][2] = 3;
	}
	ck_assert(ts_rank_blocks_cut(&blocks, count, lo, hi, open_faces));
	ck_assert_int_eq(ts_rank_loads_shift(&blocks, &points, 0, 10, 1, &iterations), TS_OK);
	ck_assert_int_le(iterations, 10);
	for (int j = 1; j < 4; j++) /* ten bisections of the length 2 */
		ck_assert_double_eq_tol(ts_rank_blocks_faces(&blocks, 0, k)[j], lo[0] + 0.25 * j, 2. / 1024);
	ck_assert_double_eq(ts_rank_blocks_faces(&blocks, 1, k)[1], 1.5);
	iterations = 0;
	ck_assert_int_eq(ts_rank_loads_shift(&blocks, &points, 1, 100, 1.0, &iterations), TS_OK);
	for (k[0] = 0; k[0] < 4; k[0]++)
		ck_assert_double_eq_tol(ts_rank_blocks_faces(&blocks, 1, k)[1], 0.5, 0.51 / POINTS);
	iterations = 0; /* is even already */
	ck_assert_int_eq(ts_rank_loads_shift(&blocks, &points, 1, 100, 1.1, &iterations), TS_OK);
	ck_assert_int_eq(iterations, 1);
	ts_rank_blocks_release(&blocks);
}
END_TEST

static void count_visit(void *context, int rank)
{
	((int *)context)[rank]++;
}

static bool is_inside(const struct ts_rank_blocks *blocks, int rank, const double x[3], double reach)
{
	const struct ts_rank_block block = ts_rank_blocks_block(blocks, rank);

	return ts_rank_block_inside(&block, x, reach);
}

/* The blocks fill the box without overlap, and visits are those of the blocks within reach. */
static void expect_partition(const struct ts_rank_blocks *blocks, int ranks)
{
	struct ts_rng rng = ts_rng_start(12, 0);

	for (int k = 0; k < 1000; k++) {
		double x[3], reach = 0.2 * ts_rng_uniform(&rng);
		int visits[32] = { 0 }, owner, others = 0;

		for (int d = 0; d < 3; d++)
			x[d] = lo[d] + (hi[d] - lo[d]) * ts_rng_uniform(&rng);
		owner = ts_rank_blocks_owner(blocks, x);
		ts_rank_blocks_visit(blocks, x, reach, count_visit, visits);
		for (int r = 0; r < ranks; r++) {
			ck_assert_int_eq(visits[r], ts_rank_blocks_reach(blocks, r, x, reach));
			ck_assert(ts_rank_blocks_reach(blocks, r, x, 0) == (r == owner));
			others += visits[r] && r != owner;
			for (int d = 0; d < 3 && r == owner; d++) {
				struct ts_rank_side side = ts_rank_blocks_side(blocks, r, d);

				ck_assert(x[d] >= side.face[0] && x[d] <= side.face[1]);
			}
		}
		ck_assert_int_eq(visits[owner], 1);
		if (is_inside(blocks, owner, x, reach))
			ck_assert_int_eq(others, 0);
	}
}

/* A point on the lower faces of a block, or anywhere else in the box, is in the block of its owner, and in no other. */
static void expect_one_inside(const struct ts_rank_blocks *blocks, int ranks)
{
	struct ts_rng rng = ts_rng_start(13, 0);

	for (int k = 0; k < 300; k++) {
		struct ts_rank_block block = ts_rank_blocks_block(blocks, k % ranks);
		double x[3];
		int owner;

		for (int d = 0; d < 3; d++)
			x[d] = k & 1 << d ? block.side[d].face[0]
					  : lo[d] + (hi[d] - lo[d]) * ts_rng_uniform(&rng);
		owner = ts_rank_blocks_owner(blocks, x);
		for (int r = 0; r < ranks; r++)
			ck_assert(is_inside(blocks, r, x, 0) == (r == owner));
	}
}

START_TEST(bisection_divides_any_number_of_ranks)
{
	static double x[POINTS][3];
	struct ts_rank_points points = { .x = x, .n = POINTS };
	struct ts_rank_load load;

	fill(x, POINTS);
	for (int ranks = 1; ranks < 32; ranks++) {
		struct ts_rank_blocks blocks = { .count = { 0 } };

		ck_assert(ts_rank_blocks_bisect(&blocks, ranks, lo, hi, ranks % 2 ? mixed : open_faces));
		ck_assert_int_eq(ts_rank_loads_bisect(&blocks, &points), TS_OK);
		ck_assert_int_eq(ts_rank_load_find(&blocks, &points, &load), TS_OK);
		ck_assert_int_eq(load.total, POINTS);
		ck_assert_int_le(load.most, POINTS / ranks + 6); /* a rounding in each level */
		expect_partition(&blocks, ranks);
		expect_one_inside(&blocks, ranks);
		ts_rank_blocks_release(&blocks);
	}
}
END_TEST

START_TEST(bisection_divides_weights)
{
	static double x[POINTS][3];
	static int64_t weight[POINTS];
	struct ts_rank_points points = { .x = x, .weight = weight, .n = POINTS };
	struct ts_rank_blocks blocks = { .count = { 0 } };
	struct ts_rank_load load;

	fill(x, POINTS);
	for (int k = 0; k < POINTS; k++)
		weight[k] = x[k][1] < 0.01 ? 1 << 20 : 1 << 16;
	ck_assert(ts_rank_blocks_bisect(&blocks, 7, lo, hi, mixed));
	ck_assert_int_eq(ts_rank_loads_bisect(&blocks, &points), TS_OK);
	ck_assert_int_eq(ts_rank_load_find(&blocks, &points, &load), TS_OK);
	ck_assert_double_le(load.imbalance, 1.02);
	points.weight = NULL;
	ck_assert_int_eq(ts_rank_load_find(&blocks, &points, &load), TS_OK);
	ck_assert_double_ge(load.imbalance, 1.1); /* not that of numbers */
	ts_rank_blocks_release(&blocks);
}
END_TEST

/* All points in one place, on the faces, or none: some ranks are empty. */
START_TEST(bisection_of_what_cannot_be_divided)
{
	static double x[100][3];
	struct ts_rank_points points = { .x = x, .n = 100 };
	struct ts_rank_load load;

	for (int what = 0; what < 4; what++) {
		struct ts_rank_blocks blocks = { .count = { 0 } };

		points.n = what ? 100 : 0;
		for (int k = 0; k < 100; k++)
			memcpy(x[k], what == 1 ? lo : hi, sizeof x[k]);
		for (int k = 0; k < 50; k++)
			memcpy(x[k], what == 3 ? lo : x[k], sizeof x[k]);
		ck_assert(ts_rank_blocks_bisect(&blocks, 6, lo, hi, open_faces));
		ck_assert_int_eq(ts_rank_loads_bisect(&blocks, &points), TS_OK);
		ck_assert_int_eq(ts_rank_load_find(&blocks, &points, &load), TS_OK);
		ck_assert_int_eq(load.most, what == 3 ? 50 : (int64_t)points.n);
		ts_rank_blocks_release(&blocks);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("rank");
	TCase *tests = tcase_create("loads");
	SRunner *runner;
	int failed;

	tcase_add_test(tests, imbalance_is_the_largest_load_by_the_mean);
	tcase_add_test(tests, shifted_cuts_divide_the_load);
	tcase_add_test(tests, bisection_divides_any_number_of_ranks);
	tcase_add_test(tests, bisection_divides_weights);
	tcase_add_test(tests, bisection_of_what_cannot_be_divided);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
