#include "immersed/connected_cells.h"

#include <string.h>

#include "base/alloc.h"

#include "base/banned.h"

static size_t first_of_set(struct ts_connected_cells *c, size_t run)
{
	while (c->set[run] != run)
		run = c->set[run] = c->set[c->set[run]];
	return run;
}

/* The first run of the two sets becomes that of both. */
static void unite(struct ts_connected_cells *c, size_t a, size_t b)
{
	a = first_of_set(c, a);
	b = first_of_set(c, b);
	if (a < b)
		c->set[b] = a;
	else
		c->set[a] = b;
}

/* Whether all faces of [from, to) are covered. */
static bool all_covered(const uint16_t *owner, int from, int to)
{
	for (int i = from; i < to; i++)
		if (!owner[i])
			return false;
	return true;
}

static bool some_covered(const uint16_t *owner, int n)
{
	uint16_t any = 0;

	for (int i = 0; i < n; i++)
		any |= owner[i];
	return any != 0;
}

static size_t row_number(const struct ts_grid *grid, int j, int k)
{
	return (size_t)k * (size_t)grid->n[1] + (size_t)j;
}

/* End of a run: the first cell after it. */
static int run_end(const struct ts_connected_cells *c, size_t row, size_t run)
{
	return run + 1 < c->row[row + 1] ? c->begin[run + 1] : c->grid->n[0];
}

static enum ts_status begin_run(struct ts_connected_cells *c, int i)
{
	TS_TRY(TS_GROW(c->begin, c->begin_capacity, c->nruns + 1));
	TS_TRY(TS_GROW(c->set, c->set_capacity, c->nruns + 1));
	c->begin[c->nruns] = i;
	c->set[c->nruns] = c->nruns;
	c->nruns++;
	return TS_OK;
}

/* owner: of the lower faces across x of the row. */
static enum ts_status find_runs(struct ts_connected_cells *c, size_t row, const uint16_t *owner)
{
	const int n = c->grid->n[0];

	c->row[row] = c->nruns;
	TS_TRY(begin_run(c, 0));
	if (some_covered(owner, n))
		for (int i = 1; i < n; i++)
			if (owner[i])
				TS_TRY(begin_run(c, i));
	c->row[row + 1] = c->nruns;
	if (c->grid->periodic[0] && !owner[0])
		unite(c, c->row[row], c->nruns - 1);
	return TS_OK;
}

/* Unites the runs of two rows that share a face; owner: of the faces between the rows. */
static void unite_rows(struct ts_connected_cells *c, size_t a, size_t b, const uint16_t *owner)
{
	const bool covered = some_covered(owner, c->grid->n[0]);
	size_t run_a = c->row[a], run_b = c->row[b];

	while (run_a < c->row[a + 1] && run_b < c->row[b + 1]) {
		const int from_a = c->begin[run_a], from_b = c->begin[run_b];
		const int to_a = run_end(c, a, run_a), to_b = run_end(c, b, run_b);
		const int from = from_a > from_b ? from_a : from_b, to = to_a < to_b ? to_a : to_b;

		if (!covered || !all_covered(owner, from, to))
			unite(c, run_a, run_b);
		run_a += to_a == to;
		run_b += to_b == to;
	}
}

/* Unites the row with that below it along y and z. */
static void unite_with_rows_below(struct ts_connected_cells *c, const ts_face_owners owner, int j, int k)
{
	const struct ts_grid *grid = c->grid;
	const size_t at = ts_at(grid, 0, j, k), row = row_number(grid, j, k);

	if (j > 0)
		unite_rows(c, row, row_number(grid, j - 1, k), owner[1] + at);
	if (k > 0)
		unite_rows(c, row, row_number(grid, j, k - 1), owner[2] + at);
}

static void unite_across_periodic_boundaries(struct ts_connected_cells *c, const ts_face_owners owner)
{
	const struct ts_grid *grid = c->grid;

	if (grid->periodic[1])
		for (int k = 0; k < grid->n[2]; k++)
			unite_rows(c, row_number(grid, 0, k), row_number(grid, grid->n[1] - 1, k),
				   owner[1] + ts_at(grid, 0, 0, k));
	if (grid->periodic[2] && grid->dimensions == 3)
		for (int j = 0; j < grid->n[1]; j++)
			unite_rows(c, row_number(grid, j, 0), row_number(grid, j, grid->n[2] - 1),
				   owner[2] + ts_at(grid, 0, j, 0));
}

enum ts_status ts_connected_cells_find(struct ts_connected_cells *c, const struct ts_grid *grid,
				       const ts_face_owners owner)
{
	*c = (struct ts_connected_cells){ .grid = grid };
	c->row = ts_alloc((size_t)grid->n[1] * (size_t)grid->n[2] + 1, sizeof *c->row);
	if (!c->row)
		return TS_NOMEM;
	TS_TRY(begin_run(c, 0)); /* the outside */
	for (int k = 0; k < grid->n[2]; k++)
		for (int j = 0; j < grid->n[1]; j++) {
			TS_TRY(find_runs(c, row_number(grid, j, k), owner[0] + ts_at(grid, 0, j, k)));
			unite_with_rows_below(c, owner, j, k);
		}
	unite_across_periodic_boundaries(c, owner);
	return TS_OK;
}

void ts_connected_cells_release(struct ts_connected_cells *c)
{
	ts_free(c->row);
	ts_free(c->begin);
	ts_free(c->set);
}

/* Connects the runs of a row with a face on the boundary across y or z; owner: of these faces. */
static void open_row(struct ts_connected_cells *c, size_t row, const uint16_t *owner)
{
	for (size_t run = c->row[row]; run < c->row[row + 1]; run++)
		if (!all_covered(owner, c->begin[run], run_end(c, row, run)))
			unite(c, 0, run);
}

void ts_connected_cells_open_face(struct ts_connected_cells *c, const ts_face_owners owner, int d,
				  enum ts_grid_side side)
{
	const struct ts_grid *grid = c->grid;
	const int from[3] = { 0, d == 1 && side == TS_HIGH ? grid->n[1] - 1 : 0,
			      d == 2 && side == TS_HIGH ? grid->n[2] - 1 : 0 };
	const int to[3] = { 0, d == 1 && side == TS_LOW ? 1 : grid->n[1],
			    d == 2 && side == TS_LOW ? 1 : grid->n[2] };

	for (int k = from[2]; k < to[2]; k++)
		for (int j = from[1]; j < to[1]; j++) {
			const size_t row = row_number(grid, j, k);
			const int i = d == 0 && side == TS_HIGH ? grid->n[0] - 1 : 0;
			const uint16_t *faces =
				owner[d] + ts_at(grid, i, j, k) + (side == TS_HIGH ? grid->stride[d] : 0);

			if (d != 0)
				open_row(c, row, faces);
			else if (!*faces)
				unite(c, 0, side == TS_HIGH ? c->row[row + 1] - 1 : c->row[row]);
		}
}

void ts_connected_cells_complete(struct ts_connected_cells *c)
{
	for (size_t run = 0; run < c->nruns; run++)
		c->set[run] = c->set[c->set[run]];
}

size_t ts_connected_cells_run(const struct ts_connected_cells *c, const int i[3])
{
	const size_t row = row_number(c->grid, i[1], i[2]);
	size_t low = c->row[row], high = c->row[row + 1];

	while (high - low > 1) {
		const size_t middle = low + (high - low) / 2;

		if (c->begin[middle] <= i[0])
			low = middle;
		else
			high = middle;
	}
	return low;
}
