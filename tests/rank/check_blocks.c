/* Blocks of ranks: which are chosen, whose a point is, and which it is near. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "math/rng.h"
#include "rank/blocks.h"

enum { POINTS = 2000 };

static void expect_grid(int n, const int given[3], const double length[3], int dimension, int a, int b, int c)
{
	const double area[3] = { length[1] * length[2], length[0] * length[2], length[0] * length[1] };
	int out[3] = { 0 };

	ck_assert(ts_rank_blocks_choose(n, given, area, dimension, out));
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

START_TEST(halves_of_points_fill_space)
{
	static double x[POINTS][3];
	struct ts_rng rng = ts_rng_start(4711, 2);
	double unlike[3];

	for (int i = 0; i < POINTS; i++)
		for (int d = 0; d < 3; d++)
			x[i][d] = (d + 1) * ts_rng_uniform(&rng);
	ck_assert(ts_rank_points_unlike(x, POINTS, unlike));
	for (int d = 0; d < 3; d++)
		ck_assert_double_lt(unlike[d], 0.05);
	for (int i = 0; i < POINTS; i++) /* half of them in a quarter of the space */
		x[i][2] *= x[i][2] < 1.5 ? 1 : 3;
	ck_assert(ts_rank_points_unlike(x, POINTS, unlike));
	ck_assert_double_lt(unlike[0], 0.05);
	ck_assert_double_gt(unlike[2], 0.3);
	ck_assert(ts_rank_points_unlike(x, 10, unlike) && unlike[2] == 0);
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

static void note_visit(void *context, int rank)
{
	((int *)context)[rank]++;
}

START_TEST(points_belong_to_one_block_and_are_near_others)
{
	static const int count[3] = { 3, 2, 4 };
	static const double lo[3] = { -1, 0.5, 1e-3 }, hi[3] = { 2, 1.5, 3e-3 };
	static const bool periodic[3] = { true, false, true };
	struct ts_rank_blocks blocks = { .count = { 0 } };
	struct ts_rng rng = ts_rng_start(4711, 0);
	int near = 0, outside = 0;

	ck_assert(ts_rank_blocks_cut(&blocks, count, lo, hi, periodic));
	for (int k = 0; k < POINTS; k++) {
		double x[3], reach = 4e-4 * ts_rng_uniform(&rng);
		struct ts_rank_block own;
		int owner, expected = 0, factor = 1, visits[24] = { 0 }, others = 0;

		for (int d = 0; d < 3; d++)
			x[d] = lo[d] + (hi[d] - lo[d]) * ts_rng_uniform(&rng);
		for (int d = 0; d < 3; d++, factor *= count[d - 1])
			expected += factor * (int)((x[d] - lo[d]) / (hi[d] - lo[d]) * count[d]);
		owner = ts_rank_blocks_owner(&blocks, x);
		ck_assert_int_eq(owner, expected);
		ts_rank_blocks_visit(&blocks, x, reach, note_visit, visits);
		for (int r = 0; r < 24; r++) {
			const int at[3] = { r % 3, r / 3 % 2, r / 6 };
			bool inside = true;

			for (int d = 0; d < 3; d++)
				inside &= distance_from(x[d], at[d], count[d], lo[d], hi[d] - lo[d],
							periodic[d]) <= reach;
			ck_assert(ts_rank_blocks_reach(&blocks, r, x, reach) == inside);
			ck_assert_int_eq(visits[r], inside);
			others += inside && r != owner;
			near += inside && r != owner;
		}
		own = ts_rank_blocks_block(&blocks, owner);
		if (ts_rank_block_inside(&own, x, reach))
			ck_assert_int_eq(others, 0);
		else
			outside++;
	}
	ck_assert_int_gt(near, POINTS / 10);
	ck_assert_int_lt(outside, 3 * POINTS / 4);
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

/* A heap whose height depends on x and y: each block gets the same number of points. */
START_TEST(balanced_blocks_have_equal_numbers)
{
	static const int count[3] = { 3, 2, 4 };
	static const double lo[3] = { 0, 0, 0 }, hi[3] = { 1, 2, 3 };
	static const bool periodic[3] = { true, false, false };
	static double x[POINTS][3], sorted[POINTS][3];
	struct ts_rank_blocks blocks = { .count = { 0 } };
	struct ts_rng rng = ts_rng_start(4711, 1);
	int number[24] = { 0 };

	for (int k = 0; k < POINTS; k++) {
		x[k][0] = pow(ts_rng_uniform(&rng), 2);
		x[k][1] = 2 * ts_rng_uniform(&rng) * x[k][0];
		x[k][2] = 3 * ts_rng_uniform(&rng) * x[k][0] * x[k][1];
	}
	memcpy(sorted, x, sizeof x);
	ck_assert(ts_rank_blocks_cut(&blocks, count, lo, hi, periodic));
	ts_rank_blocks_balance(&blocks, sorted, POINTS);
	for (int k = 0; k < POINTS; k++) {
		int owner = ts_rank_blocks_owner(&blocks, x[k]);

		number[owner]++;
		for (int r = 0; r < 24; r++) /* the blocks do not overlap */
			ck_assert(ts_rank_blocks_reach(&blocks, r, x[k], 0) == (r == owner));
	}
	for (int r = 0; r < 24; r++)
		ck_assert_int_le(abs(number[r] - POINTS / 24), 1);
	ts_rank_blocks_release(&blocks);
}
END_TEST

/* Layers are not cut; if all points are in one place, or there are none, all belong to one block. */
START_TEST(balance_of_equal_coordinates)
{
	static const int count[3] = { 3, 2, 1 };
	static const double lo[3] = { 0, 0, 0 }, hi[3] = { 1, 1, 1 };
	static const bool periodic[3] = { false, false, false };
	static const double layers[] = { 0.1, 0.1, 0.1, 0.2, 0.3, 0.3, 0.4, 0.4, 0.4, 0.4 };
	static const double middle[3] = { 0.5, 0.5, 0.5 };
	double x[10][3];
	struct ts_rank_blocks blocks = { .count = { 0 } };

	for (int k = 0; k < 10; k++)
		x[k][0] = x[k][1] = x[k][2] = layers[k];
	ck_assert(ts_rank_blocks_cut(&blocks, count, lo, hi, periodic));
	ts_rank_blocks_balance(&blocks, x, 10);
	ck_assert_double_eq_tol(blocks.cut[0][1], 0.15, 1e-15);
	ck_assert_double_eq_tol(blocks.cut[0][2], 0.35, 1e-15);
	for (int k = 0; k < 10; k++)
		x[k][0] = x[k][1] = x[k][2] = 0.5;
	ts_rank_blocks_balance(&blocks, x, 10);
	ck_assert_int_eq(ts_rank_blocks_owner(&blocks, middle), 5);
	ts_rank_blocks_balance(&blocks, x, 0);
	ck_assert_int_eq(ts_rank_blocks_owner(&blocks, middle), 5);
	ts_rank_blocks_release(&blocks);
}
END_TEST

/* The outer faces follow the box, the inner ones stay. */
START_TEST(blocks_fit_the_box)
{
	static const int count[3] = { 2, 1, 1 };
	static const double lo[3] = { 0, 0, 0 }, hi[3] = { 1, 1, 1 }, more[3] = { 2, 3, 4 };
	static const bool periodic[3] = { true, true, true };
	struct ts_rank_blocks blocks = { .count = { 0 } };

	ck_assert(ts_rank_blocks_cut(&blocks, count, lo, hi, periodic));
	ts_rank_blocks_fit(&blocks, lo, more);
	ck_assert(blocks.cut[0][1] == 0.5 && blocks.cut[0][2] == 2 && blocks.cut[2][0] == 0 &&
		  blocks.cut[2][1] == 4 && blocks.length[1] == 3);
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
	tcase_add_test(tests, halves_of_points_fill_space);
	tcase_add_test(tests, points_belong_to_one_block_and_are_near_others);
	tcase_add_test(tests, points_outside_belong_to_the_outer_blocks);
	suite_add_tcase(suite, tests);
	tcase_add_test(tests, balanced_blocks_have_equal_numbers);
	tcase_add_test(tests, balance_of_equal_coordinates);
	tcase_add_test(tests, blocks_fit_the_box);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
