#include "flow/cell_owners.h"

#include <string.h>

#include "base/alloc.h"
#include "base/hash.h"

#include "base/banned.h"

/* ---- boxes */

struct ts_cell_box ts_cell_box_common(const struct ts_cell_box *a, const struct ts_cell_box *b)
{
	struct ts_cell_box common;

	for (int d = 0; d < 3; d++) {
		common.from[d] = a->from[d] > b->from[d] ? a->from[d] : b->from[d];
		common.to[d] = a->to[d] < b->to[d] ? a->to[d] : b->to[d];
	}
	return common;
}

size_t ts_cell_box_size(const struct ts_cell_box *box)
{
	size_t size = 1;

	for (int d = 0; d < 3; d++)
		size *= box->to[d] > box->from[d] ? (size_t)(box->to[d] - box->from[d]) : 0;
	return size;
}

double *ts_cell_box_pack(const struct ts_grid *grid, const struct ts_cell_box *box, const double *field,
			 double *to)
{
	const size_t n = ts_cell_box_size(box) ? (size_t)(box->to[0] - box->from[0]) : 0;

	for (int k = box->from[2]; k < box->to[2] && n; k++)
		for (int j = box->from[1]; j < box->to[1]; j++, to += n)
			memcpy(to, field + ts_at(grid, box->from[0], j, k), n * sizeof *to);
	return to;
}

const double *ts_cell_box_unpack(const struct ts_grid *grid, const struct ts_cell_box *box,
				 const double *from, double *field)
{
	const size_t n = ts_cell_box_size(box) ? (size_t)(box->to[0] - box->from[0]) : 0;

	for (int k = box->from[2]; k < box->to[2] && n; k++)
		for (int j = box->from[1]; j < box->to[1]; j++, from += n)
			memcpy(field + ts_at(grid, box->from[0], j, k), from, n * sizeof *from);
	return from;
}

/* ---- of the ranks */

static void hash_blocks(struct ts_hash *hash, const struct ts_rank_blocks *b)
{
	size_t parts = 1;

	ts_hash_add(hash, b->count, sizeof b->count);
	if (b->bisection) {
		for (int r = 0; r < b->count[0] - 1; r++) {
			ts_hash_add(hash, &b->bisection[r].dim, sizeof b->bisection[r].dim);
			ts_hash_add(hash, &b->bisection[r].at, sizeof b->bisection[r].at);
		}
		return;
	}
	for (int d = 0; d < 3; parts *= (size_t)b->count[d++])
		ts_hash_add(hash, b->cut[d], parts * ((size_t)b->count[d] + 1) * sizeof *b->cut[d]);
}

uint64_t ts_cell_owners_hash(const struct ts_grid *grid, const struct ts_rank_blocks *blocks)
{
	struct ts_hash hash = ts_hash_start();

	if (blocks)
		hash_blocks(&hash, blocks);
	ts_hash_add(&hash, grid->n, sizeof grid->n);
	ts_hash_add(&hash, grid->periodic, sizeof grid->periodic);
	for (int d = 0; d < 3; d++)
		ts_hash_add(&hash, grid->face[d], ((size_t)grid->n[d] + 1) * sizeof *grid->face[d]);
	return ts_hash_value(&hash);
}

/* The first cell along axis d whose centre is not below x. */
static int first_from(const struct ts_grid *grid, int d, double x)
{
	int low = 0, high = grid->n[d];

	while (low < high) {
		const int middle = low + (high - low) / 2;

		if (grid->centre[d][middle] >= x)
			high = middle;
		else
			low = middle + 1;
	}
	return low;
}

/* A block has the places from its lower face on, below its upper one (ts_rank_blocks_owner); those outside of the box belong
 * to the nearest block. */
static struct ts_cell_box box_of(const struct ts_grid *grid, const struct ts_rank_blocks *blocks, int rank)
{
	struct ts_cell_box box;

	for (int d = 0; d < 3; d++) {
		const struct ts_rank_side side = ts_rank_blocks_side(blocks, rank, d);
		const bool lowest = side.face[0] <= blocks->lo[d],
			   highest = side.face[1] >= blocks->lo[d] + blocks->length[d];

		box.from[d] = lowest ? 0 : first_from(grid, d, side.face[0]);
		box.to[d] = highest ? grid->n[d] : first_from(grid, d, side.face[1]);
		if (box.to[d] == grid->n[d] && box.from[d] < box.to[d] && grid->ghosts[d] > 0 &&
		    !grid->periodic[d])
			box.to[d]++;
	}
	return box;
}

enum ts_status ts_cell_owners_make(struct ts_cell_owners *o, uint64_t hash, const struct ts_grid *grid,
				   const struct ts_rank_blocks *blocks, bool all)
{
	const int ranks = ts_rank_blocks_number(blocks);

	hash = all ? ~hash : hash;
	if (o->ranks && o->made_for == hash)
		return TS_OK;
	o->ranks = 0; /* until it is made */
	TS_TRY(TS_GROW(o->box, o->box_capacity, (size_t)ranks));
	TS_TRY(TS_GROW(o->size, o->size_capacity, (size_t)ranks));
	for (int r = 0; r < ranks; r++)
		o->box[r] = box_of(grid, blocks, r);
	o->ranks = ranks;
	o->made_for = hash;
	o->all = all;
	return TS_OK;
}

void ts_cell_owners_release(struct ts_cell_owners *o)
{
	ts_free(o->box);
	ts_free(o->size);
	ts_parcel_release(&o->mine);
	ts_parcel_release(&o->shared);
	*o = (struct ts_cell_owners){ 0 };
}

/* ---- values of all cells */

static enum ts_status pack(struct ts_cell_owners *o, int rank, const struct ts_grid *grid,
			   double *const *field, size_t n)
{
	double *to;

	o->mine.n = 0;
	to = (double *)(void *)ts_parcel_extend(&o->mine, ts_cell_owners_count(o, rank) * n * sizeof *to);
	if (!to)
		return TS_NOMEM;
	for (size_t f = 0; f < n; f++)
		to = ts_cell_box_pack(grid, &o->box[rank], field[f], to);
	return TS_OK;
}

static void unpack(const struct ts_cell_owners *o, int own, const struct ts_grid *grid, double *const *field,
		   size_t n)
{
	const double *from = (const double *)(const void *)o->shared.data;

	for (int r = 0; r < o->ranks; r++) {
		if (r == own) {
			from += n * ts_cell_owners_count(o, r);
			continue;
		}
		for (size_t f = 0; f < n; f++)
			from = ts_cell_box_unpack(grid, &o->box[r], from, field[f]);
	}
}

enum ts_status ts_cell_owners_share(struct ts_cell_owners *o, struct ts_world *world,
				    const struct ts_grid *grid, double *const *field, size_t n)
{
	if (o->all || !n)
		return TS_OK;
	for (int r = 0; r < o->ranks; r++)
		o->size[r] = n * sizeof(double) * ts_cell_owners_count(o, r);
	TS_TRY(pack(o, world->rank, grid, field, n));
	o->shared.n = 0;
	TS_TRY(ts_world_share_known(world, &o->mine, o->size, &o->shared));
	unpack(o, world->rank, grid, field, n);
	return TS_OK;
}
