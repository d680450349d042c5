#include "rank/slabs.h"

#include "base/alloc.h"

#include "base/banned.h"

enum ts_status ts_slabs_make(struct ts_slabs *slabs, struct ts_world *world, int n)
{
	const size_t ranks = world ? (size_t)world->n : 0;

	slabs->n = n;
	slabs->active = false;
	if (slabs->world == world)
		return TS_OK;
	ts_slabs_release(slabs);
	slabs->n = n;
	slabs->out = ts_alloc(2 * ranks, sizeof *slabs->out);
	slabs->packed = ts_alloc(2 * ranks, sizeof *slabs->packed);
	if (!slabs->out || !slabs->packed)
		return TS_NOMEM;
	slabs->in = slabs->out + ranks;
	slabs->world = world;
	return TS_OK;
}

void ts_slabs_release(struct ts_slabs *slabs)
{
	for (int r = 0; slabs->world && r < 2 * slabs->world->n; r++)
		ts_parcel_release(&slabs->packed[r]);
	ts_free(slabs->out);
	ts_free(slabs->packed);
	*slabs = (struct ts_slabs){ 0 };
}

/* The planes from .. to - 1 of a field as a parcel. */
static struct ts_parcel planes(double *field, size_t stride, size_t from, size_t to)
{
	return (struct ts_parcel){ .data = (unsigned char *)(field + from * stride),
				   .n = (to - from) * stride * sizeof *field };
}

void ts_slabs_share(const struct ts_slabs *slabs, const struct ts_slabs_field *field)
{
	const int ranks = ts_slabs_ranks(slabs);
	const size_t n = ranks > 1 ? (size_t)slabs->n : 0, before = (size_t)field->before;
	double *lowest = field->first - before * field->stride;

	if (ranks == 1)
		return;
	for (int r = 0; r < ranks; r++)
		slabs->in[r] = planes(lowest, field->stride, r ? before + ts_slabs_part(slabs, r, n) : 0,
				      before + ts_slabs_part(slabs, r + 1, n) +
					      (r == ranks - 1 ? (size_t)field->behind : 0));
	for (int r = 0; r < ranks; r++)
		slabs->out[r] = slabs->in[slabs->world->rank];
	ts_world_swap(slabs->world, slabs->out, slabs->in);
}

/* What this rank sends so that each gets the `depth` planes of the rank beside it that are next to its own ones, up: of that
 * above. */
static void add_side(const struct ts_slabs *slabs, const struct ts_slabs_field *field, size_t depth, bool up,
		     bool ring)
{
	const int ranks = slabs->world->n, rank = slabs->world->rank;
	const int from = (rank + (up ? 1 : ranks - 1)) % ranks, to = (rank + (up ? ranks - 1 : 1)) % ranks;
	const bool first = rank == 0, last = rank == ranks - 1;
	size_t own[2], there[2];

	for (int k = 0; k < 2; k++) {
		own[k] = ts_slabs_part(slabs, rank + k, (size_t)slabs->n);
		there[k] = ts_slabs_part(slabs, from + k, (size_t)slabs->n);
	}
	if (depth && (ring || !(up ? first : last)))
		slabs->out[to] = planes(field->first, field->stride, up ? own[0] : own[1] - depth,
					up ? own[0] + depth : own[1]);
	if (depth && (ring || !(up ? last : first)))
		slabs->in[from] = planes(field->first, field->stride, up ? there[0] : there[1] - depth,
					 up ? there[0] + depth : there[1]);
}

static void clear_parcels(const struct ts_slabs *slabs)
{
	for (int r = 0; r < slabs->world->n; r++)
		slabs->in[r] = slabs->out[r] = (struct ts_parcel){ 0 };
}

/* In a ring of two ranks each is on both sides of the other: two exchanges. */
void ts_slabs_share_beside(const struct ts_slabs *slabs, const struct ts_slabs_field *field, int below,
			   int above, bool ring)
{
	const int ranks = ts_slabs_ranks(slabs);
	const bool twice = ring && ranks == 2 && below && above;

	if (ranks == 1)
		return;
	clear_parcels(slabs);
	add_side(slabs, field, (size_t)above, true, ring);
	if (twice) {
		ts_world_swap(slabs->world, slabs->out, slabs->in);
		clear_parcels(slabs);
	}
	add_side(slabs, field, (size_t)below, false, ring);
	ts_world_swap(slabs->world, slabs->out, slabs->in);
}
