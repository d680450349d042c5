#include "flow/cell_owners.h"

#include <string.h>

#include "base/alloc.h"

#include "base/banned.h"

/* Number of points of fields along axis d: the faces of the upper boundary are one more. */
static int points(const struct ts_grid *grid, int d)
{
	return grid->n[d] + (grid->ghosts[d] > 0 && !grid->periodic[d]);
}

static void find_owners(struct ts_cell_owners *o, const struct ts_grid *grid,
			const struct ts_rank_blocks *blocks)
{
	const int *n = grid->n;
	int32_t *rank = o->rank;

	for (int k = 0; k < n[2]; k++)
		for (int j = 0; j < n[1]; j++)
			for (int i = 0; i < n[0]; i++) {
				const double x[3] = { grid->centre[0][i], grid->centre[1][j],
						      grid->centre[2][k] };

				*rank++ = (int32_t)ts_rank_blocks_owner(blocks, x);
			}
}

/* The rank of a point. */
static int32_t owner_of(const struct ts_cell_owners *o, const struct ts_grid *grid, int i, int j, int k)
{
	const int *n = grid->n;
	const int at[3] = { i < n[0] ? i : n[0] - 1, j < n[1] ? j : n[1] - 1, k < n[2] ? k : n[2] - 1 };

	return o->rank[(at[2] * n[1] + at[1]) * n[0] + at[0]];
}

/* Counts the points of each rank, or lists them from `next` of its rank on. */
static void visit_points(struct ts_cell_owners *o, const struct ts_grid *grid, size_t *count, size_t *next)
{
	for (int k = 0; k < points(grid, 2); k++)
		for (int j = 0; j < points(grid, 1); j++)
			for (int i = 0; i < points(grid, 0); i++) {
				const int32_t rank = owner_of(o, grid, i, j, k);

				if (count)
					count[rank]++;
				else
					o->point[next[rank]++] = ts_at(grid, i, j, k);
			}
}

/* start[r + 1] is used as the next free index of rank r. */
static void list_points(struct ts_cell_owners *o, const struct ts_grid *grid)
{
	memset(o->start, 0, ((size_t)o->ranks + 2) * sizeof *o->start);
	visit_points(o, grid, o->start + 2, NULL);
	for (int r = 0; r < o->ranks; r++)
		o->start[r + 2] += o->start[r + 1];
	visit_points(o, grid, NULL, o->start + 1);
}

enum ts_status ts_cell_owners_make(struct ts_cell_owners *o, uint64_t hash, const struct ts_grid *grid,
				   const struct ts_rank_blocks *blocks, bool all)
{
	size_t n = 1;

	if (o->ranks && o->made_for == hash)
		return TS_OK;
	o->ranks = 0; /* until it is made */
	for (int d = 0; d < 3; d++)
		n *= (size_t)points(grid, d);
	TS_TRY(TS_GROW(o->rank, o->rank_capacity, ts_grid_cells(grid)));
	TS_TRY(TS_GROW(o->point, o->point_capacity, n));
	TS_TRY(TS_GROW(o->start, o->start_capacity, (size_t)ts_rank_blocks_number(blocks) + 2));
	TS_TRY(TS_GROW(o->size, o->size_capacity, (size_t)ts_rank_blocks_number(blocks)));
	o->ranks = ts_rank_blocks_number(blocks);
	o->made_for = hash;
	o->all = all;
	find_owners(o, grid, blocks);
	list_points(o, grid);
	return TS_OK;
}

void ts_cell_owners_release(struct ts_cell_owners *o)
{
	ts_free(o->rank);
	ts_free(o->point);
	ts_free(o->start);
	ts_free(o->size);
	ts_parcel_release(&o->mine);
	ts_parcel_release(&o->shared);
	*o = (struct ts_cell_owners){ 0 };
}

/* ---- values of all cells */

static enum ts_status pack(struct ts_cell_owners *o, int rank, double *const *field, size_t n, size_t fields)
{
	const size_t *point = o->point + o->start[rank], cells = ts_cell_owners_count(o, rank);
	double *to;

	o->mine.n = 0;
	to = (double *)(void *)ts_parcel_extend(&o->mine, cells * fields * sizeof *to);
	if (!to)
		return TS_NOMEM;
	for (size_t f = 0; f < n; f++)
		for (size_t k = 0; field[f] && k < cells; k++)
			*to++ = field[f][point[k]];
	return TS_OK;
}

static void unpack(const struct ts_cell_owners *o, int own, double *const *field, size_t n, size_t fields)
{
	const double *from = (const double *)(const void *)o->shared.data;

	for (int r = 0; r < o->ranks; r++) {
		const size_t *point = o->point + o->start[r], cells = ts_cell_owners_count(o, r);

		if (r == own) {
			from += fields * cells;
			continue;
		}
		for (size_t f = 0; f < n; f++)
			for (size_t k = 0; field[f] && k < cells; k++)
				field[f][point[k]] = *from++;
	}
}

enum ts_status ts_cell_owners_share(struct ts_cell_owners *o, struct ts_world *world, double *const *field,
				    size_t n)
{
	size_t fields = 0;

	for (size_t f = 0; f < n; f++)
		fields += field[f] != NULL;
	if (o->all || !fields)
		return TS_OK;
	for (int r = 0; r < o->ranks; r++)
		o->size[r] = fields * sizeof(double) * ts_cell_owners_count(o, r);
	TS_TRY(pack(o, world->rank, field, n, fields));
	o->shared.n = 0;
	TS_TRY(ts_world_share_known(world, &o->mine, o->size, &o->shared));
	unpack(o, world->rank, field, n, fields);
	return TS_OK;
}
