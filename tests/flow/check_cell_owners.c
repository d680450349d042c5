/* The box of cells of each rank has those whose centres are in its block; numbers of a part of the cells keep their order. */
#include <stdlib.h>

#include "asserts.h"
#include "coupling/cell_frame.h"
#include "flow/cell_owners.h"
#include "math/rng.h"
#include "rank/loads.h"

enum { POINTS = 500, LONGEST = 24 };

static const double LOW[3] = { -1, 0, 2 }, HIGH[3] = { 1, 0.5, 5 };

/* Widths of cells that differ. */
static void make_grid(struct ts_grid *grid, const int n[3], const bool periodic[3], struct ts_rng *rng)
{
	double face[3][LONGEST + 1];

	for (int d = 0; d < 3; d++) {
		face[d][0] = LOW[d];
		for (int i = 1; i <= n[d]; i++)
			face[d][i] = face[d][i - 1] + 0.2 + ts_rng_uniform(rng);
		for (int i = n[d]; i >= 0; i--)
			face[d][i] = LOW[d] +
				     (face[d][i] - LOW[d]) / (face[d][n[d]] - LOW[d]) * (HIGH[d] - LOW[d]);
	}
	ck_assert_int_eq(ts_grid_make(grid, 3, n, (const double *const[3]){ face[0], face[1], face[2] },
				      periodic),
			 TS_OK);
}

static void move_cuts(struct ts_rank_blocks *blocks, struct ts_rng *rng)
{
	static double x[POINTS][3];
	const struct ts_rank_points points = { .x = x, .n = POINTS };

	for (int i = 0; i < POINTS; i++)
		for (int d = 0; d < 3; d++)
			x[i][d] = LOW[d] + (HIGH[d] - LOW[d]) * ts_rng_uniform(rng) * ts_rng_uniform(rng);
	if (blocks->bisection)
		ck_assert_int_eq(ts_rank_loads_bisect(blocks, &points), TS_OK);
	else
		ck_assert(ts_rank_blocks_balance(blocks, x, POINTS));
}

static void expect_owners(const struct ts_grid *grid, const struct ts_rank_blocks *blocks)
{
	struct ts_cell_owners owners = { 0 };
	const int ranks = ts_rank_blocks_number(blocks);

	ck_assert_int_eq(ts_cell_owners_make(&owners, ts_cell_owners_hash(grid, blocks), grid, blocks, false),
			 TS_OK);
	for (int k = 0; k < grid->n[2]; k++)
		for (int j = 0; j < grid->n[1]; j++)
			for (int i = 0; i < grid->n[0]; i++) {
				const double x[3] = { grid->centre[0][i], grid->centre[1][j],
						      grid->centre[2][k] };
				const struct ts_cell_box here = { { i, j, k }, { i + 1, j + 1, k + 1 } };

				for (int r = 0; r < ranks; r++) {
					const struct ts_cell_box common =
						ts_cell_box_common(&owners.box[r], &here);

					ck_assert_uint_eq(ts_cell_box_size(&common),
							  r == ts_rank_blocks_owner(blocks, x));
				}
			}
	ts_cell_owners_release(&owners);
}

/* All points that hold values, upper faces with the last cells. */
static void expect_all_points(const struct ts_grid *grid, const struct ts_rank_blocks *blocks)
{
	struct ts_cell_owners owners = { 0 };
	size_t all = 1, sum = 0;

	ck_assert_int_eq(ts_cell_owners_make(&owners, 1, grid, blocks, false), TS_OK);
	for (int d = 0; d < 3; d++)
		all *= (size_t)(grid->n[d] + !grid->periodic[d]);
	for (int r = 0; r < ts_rank_blocks_number(blocks); r++)
		sum += ts_cell_owners_count(&owners, r);
	ck_assert_uint_eq(sum, all);
	ts_cell_owners_release(&owners);
}

START_TEST(boxes_are_those_of_the_owners)
{
	struct ts_rng rng = ts_rng_start(4711, 3);

	for (int round = 0; round < 40; round++) {
		const int n[3] = { 1 + round % LONGEST, 3 + 7 * round % 11, 2 + 5 * round % 13 };
		const bool periodic[3] = { round & 1, round & 2, round & 4 };
		const int count[3] = { 1 + round % 3, 1 + round % 4, 1 + round % 5 };
		struct ts_rank_blocks blocks = { 0 };
		struct ts_grid grid = { 0 };

		make_grid(&grid, n, periodic, &rng);
		if (round % 2)
			ck_assert(ts_rank_blocks_bisect(&blocks, 2 + round % 9, LOW, HIGH, periodic));
		else
			ck_assert(ts_rank_blocks_cut(&blocks, count, LOW, HIGH, periodic));
		if (round % 3)
			move_cuts(&blocks, &rng);
		expect_owners(&grid, &blocks);
		expect_all_points(&grid, &blocks);
		ts_rank_blocks_release(&blocks);
		ts_grid_release(&grid);
	}
}
END_TEST

START_TEST(numbers_of_a_part_keep_their_order)
{
	const struct ts_cell_frame frame = {
		{ { 2, { { 0, 3 }, { 7, 9 } } }, { 1, { { 2, 6 } } }, { 1, { { 0, 4 } } } }, { 5, 4, 4 }
	};
	int32_t last = -1;

	ck_assert_uint_eq(ts_cell_frame_cells(&frame), 80);
	for (int k = 0; k < 4; k++)
		for (int j = 2; j < 6; j++)
			for (int i = 0; i < 9; i++) {
				const int cell[3] = { i, j, k };
				int back[3];

				if (i >= 3 && i < 7)
					continue;
				ck_assert_int_eq(ts_cell_frame_number(&frame, cell), last + 1);
				ts_cell_frame_cell(&frame, ++last, back);
				for (int d = 0; d < 3; d++)
					ck_assert_int_eq(back[d], cell[d]);
			}
	ck_assert_int_eq(ts_cell_frame_below(&frame, 0, 5), 3);
	ck_assert_int_eq(ts_cell_frame_below(&frame, 0, 12), 5);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("cell owners");
	TCase *tcase = tcase_create("all");
	SRunner *runner;
	int failed;

	tcase_add_test(tcase, boxes_are_those_of_the_owners);
	tcase_add_test(tcase, numbers_of_a_part_keep_their_order);
	suite_add_tcase(suite, tcase);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
