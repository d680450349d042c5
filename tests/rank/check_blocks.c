/* Blocks of ranks: which are chosen, whose a point is, and which it is near. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "math/rng.h"
#include "rank/blocks.h"

enum { POINTS = 2000 };

static void expect_grid(int n, const int given[3], const double length[3], int dimension, int a, int b, int c)
{
	int out[3] = { 0 };

	ck_assert(ts_rank_blocks_choose(n, given, length, dimension, out));
	ck_assert_int_eq(out[0], a);
	ck_assert_int_eq(out[1], b);
	ck_assert_int_eq(out[2], c);
}

START_TEST(blocks_have_the_least_area)
{
	static const int any[3] = { 0, 0, 0 }, two[3] = { 2, 0, 0 }, three[3] = { 3, 0, 0 };
	static const double cube[3] = { 1, 1, 1 }, rod[3] = { 1, 1, 30 }, plate[3] = { 4, 4, 0.1 };
	int out[3];

	expect_grid(1, any, cube, 3, 1, 1, 1);
	expect_grid(8, any, cube, 3, 2, 2, 2);
	expect_grid(7, any, rod, 3, 1, 1, 7);
	expect_grid(4, any, plate, 3, 2, 2, 1);
	expect_grid(6, two, rod, 3, 2, 1, 3);
	expect_grid(6, three, cube, 2, 3, 2, 1);
	ck_assert(!ts_rank_blocks_choose(7, two, cube, 3, out));
}
END_TEST

/* Distance of x from the interval of block k of n in the unit of the box, also of its periodic images. */
static double distance_from(double x, int k, int n, double lo, double length, bool periodic)
{
	double least = INFINITY;

	for (int turn = periodic ? -1 : 0; turn <= (periodic ? 1 : 0); turn++) {
		double at = (x + turn * length - lo) / length * n;

		least = fmin(least, fmax(0, fmax(k - at, at - k - 1)) * length / n);
	}
	return least;
}

START_TEST(points_belong_to_one_block_and_are_near_others)
{
	static const int count[3] = { 3, 2, 4 };
	static const double lo[3] = { -1, 0.5, 1e-3 }, hi[3] = { 2, 1.5, 3e-3 };
	static const bool periodic[3] = { true, false, true };
	struct ts_rank_blocks blocks = { .count = { 0 } };
	struct ts_rng rng = ts_rng_start(4711, 0);
	int near = 0;

	ck_assert(ts_rank_blocks_cut(&blocks, count, lo, hi, periodic));
	for (int k = 0; k < POINTS; k++) {
		double x[3], reach = 4e-4 * ts_rng_uniform(&rng);
		int owner, expected = 0, factor = 1;

		for (int d = 0; d < 3; d++)
			x[d] = lo[d] + (hi[d] - lo[d]) * ts_rng_uniform(&rng);
		for (int d = 0; d < 3; d++, factor *= count[d - 1])
			expected += factor * (int)((x[d] - lo[d]) / (hi[d] - lo[d]) * count[d]);
		owner = ts_rank_blocks_owner(&blocks, x);
		ck_assert_int_eq(owner, expected);
		for (int r = 0; r < 24; r++) {
			const int at[3] = { r % 3, r / 3 % 2, r / 6 };
			bool inside = true;

			for (int d = 0; d < 3; d++)
				inside &= distance_from(x[d], at[d], count[d], lo[d], hi[d] - lo[d],
							periodic[d]) <= reach;
			ck_assert(ts_rank_blocks_reach(&blocks, r, x, reach) == inside);
			near += inside && r != owner;
		}
	}
	ck_assert_int_gt(near, POINTS / 10);
	ts_rank_blocks_release(&blocks);
}
END_TEST

/* Particles may leave the box before they are wrapped or deleted: they belong to the outer blocks, which have no limit
 * there. */
START_TEST(points_outside_belong_to_the_outer_blocks)
{
	static const int count[3] = { 2, 2, 1 };
	static const double lo[3] = { 0, 0, 0 }, hi[3] = { 1, 1, 1 };
	static const bool periodic[3] = { false, false, false };
	static const double out[3] = { -5, 7, 3 }, cut[3] = { 0.5, 0.5, 0 };
	struct ts_rank_blocks blocks = { .count = { 0 } };

	ck_assert(ts_rank_blocks_cut(&blocks, count, lo, hi, periodic));
	ck_assert_int_eq(ts_rank_blocks_owner(&blocks, out), 2);
	ck_assert(ts_rank_blocks_reach(&blocks, 2, out, 0));
	ck_assert(!ts_rank_blocks_reach(&blocks, 0, out, 1));
	ck_assert_int_eq(ts_rank_blocks_owner(&blocks, cut), 3);
	ts_rank_blocks_release(&blocks);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("rank");
	TCase *tests = tcase_create("blocks");
	SRunner *runner;
	int failed;

	tcase_add_test(tests, blocks_have_the_least_area);
	tcase_add_test(tests, points_belong_to_one_block_and_are_near_others);
	tcase_add_test(tests, points_outside_belong_to_the_outer_blocks);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
