/* Sets of connected cells, against a flood fill cell by cell, on random grids in which bodies cover faces. */
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "base/alloc.h"
#include "immersed/connected_cells.h"

enum { MOST = 8, CELLS = MOST * MOST * MOST, ROUNDS = 400, OUTSIDE = 0 };

struct scene {
	struct ts_grid grid;
	ts_face_owners owner;
	bool open[3][2];
};

static unsigned state;

static int draw(int n)
{
	state = state * 1664525u + 1013904223u;
	return (int)((state >> 16) % (unsigned)n);
}

static void make_scene(struct scene *s, int dimensions, int covered)
{
	double line[MOST + 1];
	int n[3] = { 1 + draw(MOST), 1 + draw(MOST), dimensions == 3 ? 1 + draw(MOST) : 1 };
	const bool periodic[3] = { draw(2) != 0, draw(2) != 0, dimensions == 3 && draw(2) != 0 };
	const double *const face[3] = { line, line, line };

	for (int i = 0; i <= MOST; i++)
		line[i] = i;
	ck_assert_int_eq(ts_grid_make(&s->grid, dimensions, n, face, periodic), TS_OK);
	for (int d = 0; d < 3; d++) {
		s->owner[d] = ts_alloc(s->grid.size, sizeof **s->owner);
		ck_assert_ptr_nonnull(s->owner[d]);
		for (size_t at = 0; at < s->grid.size; at++)
			s->owner[d][at] = draw(100) < covered ? (uint16_t)(1 + draw(3)) : 0;
		for (int side = 0; side < 2; side++)
			s->open[d][side] = d < dimensions && !periodic[d] && draw(6) == 0;
	}
}

static void release_scene(struct scene *s)
{
	for (int d = 0; d < 3; d++)
		ts_free(s->owner[d]);
	ts_grid_release(&s->grid);
}

static int number_of(const struct ts_grid *grid, const int i[3])
{
	return i[0] + grid->n[0] * (i[1] + grid->n[1] * i[2]);
}

/* The cell across a face of cell i, and whether the face is covered; false: the face is on a boundary. */
static bool cross(const struct scene *s, const int i[3], int d, int side, int other[3], bool *covered)
{
	const struct ts_grid *grid = &s->grid;
	int upper[3];

	memcpy(other, i, 3 * sizeof *other);
	other[d] += side ? 1 : -1;
	memcpy(upper, side ? other : i, sizeof upper); /* the cell whose lower face it is */
	if (other[d] >= 0 && other[d] < grid->n[d]) {
		*covered = s->owner[d][ts_at(grid, upper[0], upper[1], upper[2])] != 0;
		return true;
	}
	if (grid->periodic[d]) {
		other[d] = side ? 0 : grid->n[d] - 1;
		upper[d] = 0;
	}
	*covered = s->owner[d][ts_at(grid, upper[0], upper[1], upper[2])] != 0;
	return grid->periodic[d];
}

/* Spreads the label of cell i; returns whether a label has changed. */
static bool spread(const struct scene *s, int *label, const int i[3])
{
	int *mine = &label[number_of(&s->grid, i)], before = *mine;

	for (int d = 0; d < s->grid.dimensions; d++)
		for (int side = 0; side < 2; side++) {
			int other[3], theirs = OUTSIDE;
			bool covered, inside = cross(s, i, d, side, other, &covered);

			if (covered || (!inside && !s->open[d][side]))
				continue;
			if (inside)
				theirs = label[number_of(&s->grid, other)];
			*mine = theirs < *mine ? theirs : *mine;
		}
	return *mine != before;
}

#define EACH_CELL(grid, i)                                 \
	for (i[2] = 0; i[2] < (grid).n[2]; i[2]++)         \
		for (i[1] = 0; i[1] < (grid).n[1]; i[1]++) \
			for (i[0] = 0; i[0] < (grid).n[0]; i[0]++)

/* The least cell number + 1 of each set, or OUTSIDE. */
static void flood(const struct scene *s, int *label)
{
	bool changed = true;
	int i[3];

	EACH_CELL(s->grid, i) label[number_of(&s->grid, i)] = number_of(&s->grid, i) + 1;
	while (changed) {
		changed = false;
		EACH_CELL(s->grid, i) changed |= spread(s, label, i);
	}
}

static void compare(const struct scene *s, const int *label, const struct ts_connected_cells *cells)
{
	size_t set_of_label[CELLS + 1], label_of_set[CELLS + 1] = { 0 };
	int i[3];

	memset(set_of_label, 0xff, sizeof set_of_label);
	set_of_label[OUTSIDE] = 0;
	EACH_CELL(s->grid, i)
	{
		int mine = label[number_of(&s->grid, i)];
		size_t set = cells->set[ts_connected_cells_run(cells, i)];

		if (set_of_label[mine] == SIZE_MAX) {
			set_of_label[mine] = set;
			ck_assert_uint_eq(label_of_set[set], 0); /* no set has two labels */
			label_of_set[set] = (size_t)mine;
		}
		ck_assert_uint_eq(set, set_of_label[mine]);
	}
}

static void check_scenes(int dimensions, int covered)
{
	for (int round = 0; round < ROUNDS; round++) {
		struct scene s;
		struct ts_connected_cells cells;
		int label[CELLS];

		make_scene(&s, dimensions, covered);
		ck_assert_int_eq(ts_connected_cells_find(&cells, &s.grid, s.owner), TS_OK);
		for (int d = 0; d < 3; d++)
			for (int side = 0; side < 2; side++)
				if (s.open[d][side])
					ts_connected_cells_open_face(&cells, s.owner, d,
								     (enum ts_grid_side)side);
		ts_connected_cells_complete(&cells);
		flood(&s, label);
		compare(&s, label, &cells);
		ts_connected_cells_release(&cells);
		release_scene(&s);
	}
}

START_TEST(random_grids)
{
	static const int covered[] = { 0, 20, 50, 75, 100 };

	state = 4711;
	check_scenes(3, covered[_i]);
	check_scenes(2, covered[_i]);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("connected cells");
	TCase *tcase = tcase_create("sets");
	SRunner *runner = srunner_create(suite);
	int failed;

	tcase_add_loop_test(tcase, random_grids, 0, 5);
	suite_add_tcase(suite, tcase);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
