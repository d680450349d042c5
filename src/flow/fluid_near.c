#include "flow/fluid_near.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "flow/fluid.h"
#include "flow/fluid_slabs.h"

#include "base/banned.h"

/* ---- spans */

/* The spans of indices k, 0 <= k < n, of which mark[k] is set. */
static struct ts_cell_spans spans_of(const bool *mark, int n)
{
	struct ts_cell_spans spans = { 0 };

	for (int k = 0; k < n; k++) {
		if (!mark[k])
			continue;
		if (k == 0 || !mark[k - 1])
			spans.of[spans.n++].from = k;
		spans.of[spans.n - 1].to = k + 1;
	}
	return spans;
}

/* Sets the marks of the cells from .. to - 1, or of their images across a periodic face. */
static void mark_cells(const struct ts_grid *grid, int d, int from, int to, bool *mark)
{
	const int n = grid->n[d];

	if (grid->periodic[d] && to - from >= n) {
		from = 0;
		to = n;
	}
	for (int k = from; k < to; k++)
		if (grid->periodic[d])
			mark[(k % n + n) % n] = true;
		else if (k >= 0 && k < n)
			mark[k] = true;
}

/* ---- what is near */

/* The cell along axis d with x; across periodic faces cells are counted on. */
static int cell_with(const struct ts_grid *grid, int d, double x)
{
	const double low = grid->face[d][0], length = grid->face[d][grid->n[d]] - low;
	const double turns = grid->periodic[d] ? floor((x - low) / length) : 0;

	return ts_grid_bisect(grid, d, x - turns * length) + (int)turns * grid->n[d];
}

static struct ts_cell_spans near_along(const struct ts_fluid *fluid, const struct ts_rank_blocks *blocks,
				       int rank, int d, bool *mark)
{
	const struct ts_grid *grid = &fluid->grid;
	const struct ts_rank_side side = ts_rank_blocks_side(blocks, rank, d);
	/* a particle of another rank in the reach of an own cell adds as far beyond, and reads the next point */
	const int reach = fluid->near.reach > 1 ? fluid->near.reach : 1, pad = 2 * reach + 2;
	int from, to;

	memset(mark, 0, (size_t)grid->n[d] * sizeof *mark);
	from = side.open[0] ? -pad : cell_with(grid, d, side.face[0] - fluid->near.margin) - pad;
	to = side.open[1] ? grid->n[d] : cell_with(grid, d, side.face[1] + fluid->near.margin) + pad + 1;
	mark_cells(grid, d, from, to, mark);
	return spans_of(mark, grid->n[d]);
}

static void find_near(const struct ts_fluid *fluid, const struct ts_rank_blocks *blocks, int rank, bool *mark)
{
	const struct ts_grid *grid = &fluid->grid;
	const int planes = grid->n[2];
	struct ts_near_rank *near = &fluid->near.rank[rank];

	for (int d = 0; d < 3; d++)
		near->cell[d] = near_along(fluid, blocks, rank, d, mark);
	memset(mark, 0, (size_t)planes * sizeof *mark);
	mark_cells(grid, 2, (int)ts_slabs_part(fluid->slabs, rank, (size_t)planes) - grid->ghosts[2],
		   (int)ts_slabs_part(fluid->slabs, rank + 1, (size_t)planes) + grid->ghosts[2], mark);
	near->planes = spans_of(mark, planes);
	for (int k = 0; k < planes; k++)
		mark[k] = !mark[k] && ts_cell_spans_have(&near->cell[2], k);
	near->beyond = spans_of(mark, planes);
}

static enum ts_status make_rooms(struct ts_fluid *fluid, uint64_t hash, const struct ts_rank_blocks *blocks)
{
	struct ts_fluid_near *near = &fluid->near;
	const size_t ranks = (size_t)ts_rank_blocks_number(blocks);

	TS_TRY(TS_GROW(near->rank, near->rank_capacity, ranks));
	TS_TRY(TS_GROW(near->out, near->out_capacity, ranks));
	TS_TRY(TS_GROW(near->in, near->in_capacity, ranks));
	return ts_cell_owners_make(&near->owners, hash, &fluid->grid, blocks, false);
}

/* At first particles may be one cell beyond the block of their rank. */
static void choose_margin(struct ts_fluid *fluid)
{
	fluid->near.margin = fmax(fluid->near.margin, ts_grid_least_width(&fluid->grid));
}

enum ts_status ts_fluid_near_make(struct ts_fluid *fluid, const struct ts_rank_blocks *blocks, bool *made)
{
	struct ts_fluid_near *near = &fluid->near;
	const struct ts_grid *grid = &fluid->grid;
	const uint64_t hash = ts_cell_owners_hash(grid, blocks);
	size_t longest = 0;
	bool *mark;

	if (made)
		*made = !near->ranks || near->made_for != hash;
	if (near->ranks && near->made_for == hash)
		return TS_OK;
	near->ranks = 0; /* until it is made */
	for (int d = 0; d < 3; d++)
		longest = (size_t)grid->n[d] > longest ? (size_t)grid->n[d] : longest;
	TS_TRY(make_rooms(fluid, hash, blocks));
	mark = ts_alloc(longest, sizeof *mark);
	if (!mark)
		return TS_NOMEM;
	choose_margin(fluid);
	for (int r = 0; r < ts_rank_blocks_number(blocks); r++)
		find_near(fluid, blocks, r, mark);
	ts_free(mark);
	near->ranks = ts_rank_blocks_number(blocks);
	near->made_for = hash;
	return TS_OK;
}

void ts_fluid_near_release(struct ts_fluid_near *near)
{
	for (size_t r = 0; r < near->out_capacity; r++)
		ts_parcel_release(&near->out[r]);
	for (size_t r = 0; r < near->in_capacity; r++)
		ts_parcel_release(&near->in[r]);
	ts_cell_owners_release(&near->owners);
	ts_free(near->rank);
	ts_free(near->out);
	ts_free(near->in);
	*near = (struct ts_fluid_near){ 0 };
}

/* ---- in memory */

const struct ts_near_rank *ts_fluid_near_own(const struct ts_fluid *fluid)
{
	return &fluid->near.rank[fluid->slabs->world->rank];
}

bool ts_fluid_near_has_plane(const struct ts_fluid *fluid, int k)
{
	const int n = fluid->grid.n[2];

	return ts_cell_spans_have(&ts_fluid_near_own(fluid)->cell[2], k < 0 ? 0 : k >= n ? n - 1 : k);
}

void ts_fluid_near_clear(const struct ts_fluid *fluid, double *field)
{
	const struct ts_grid *grid = &fluid->grid;
	const struct ts_cell_spans *cell = ts_fluid_near_own(fluid)->cell;

	for (int range = 0; range < fluid->planes.ranges; range++) {
		size_t first, end;

		ts_fluid_range_values(fluid, range, &first, &end);
		memset(field + first, 0, (end - first) * sizeof *field);
	}
	for (int s = 0; s < cell[2].n; s++)
		for (int k = cell[2].of[s].from; k <= cell[2].of[s].to; k++)
			for (int t = 0; t < cell[1].n; t++) {
				const int j = cell[1].of[t].from, end = cell[1].of[t].to + 1;

				memset(field + ts_at(grid, -grid->ghosts[0], j, k), 0,
				       (size_t)((end - j) * grid->stride[1]) * sizeof *field);
			}
}
