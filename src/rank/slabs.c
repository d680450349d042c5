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

void ts_slabs_share(const struct ts_slabs *slabs, double *field, size_t stride, int more)
{
	const int ranks = ts_slabs_ranks(slabs);
	const size_t n = ranks > 1 ? (size_t)slabs->n : 0;

	if (ranks == 1)
		return;
	for (int r = 0; r < ranks; r++)
		slabs->in[r] = planes(field, stride, ts_slabs_part(slabs, r, n),
				      ts_slabs_part(slabs, r + 1, n) + (r == ranks - 1 ? (size_t)more : 0));
	for (int r = 0; r < ranks; r++)
		slabs->out[r] = slabs->in[slabs->world->rank];
	ts_world_swap(slabs->world, slabs->out, slabs->in);
}

void ts_slabs_share_next(const struct ts_slabs *slabs, double *field, size_t stride, bool ring)
{
	const int ranks = ts_slabs_ranks(slabs), rank = ranks > 1 ? slabs->world->rank : 0;
	size_t from, to, first;

	if (ranks == 1)
		return;
	for (int r = 0; r < ranks; r++)
		slabs->in[r] = slabs->out[r] = (struct ts_parcel){ 0 };
	ts_slabs_own(slabs, (size_t)slabs->n, &from, &to);
	first = rank == ranks - 1 ? 0 : to;
	if (rank > 0 || ring)
		slabs->out[(rank + ranks - 1) % ranks] = planes(field, stride, from, from + 1);
	if (rank < ranks - 1 || ring)
		slabs->in[(rank + 1) % ranks] = planes(field, stride, first, first + 1);
	ts_world_swap(slabs->world, slabs->out, slabs->in);
}
