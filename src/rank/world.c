#include "rank/world.h"

#include <string.h>

#include "base/alloc.h"

#include "base/banned.h"

unsigned char *ts_parcel_extend(struct ts_parcel *parcel, size_t n)
{
	size_t at = parcel->n;

	if (TS_GROW(parcel->data, parcel->capacity, at + n + 1) != TS_OK)
		return NULL;
	parcel->n += n;
	return parcel->data + at;
}

enum ts_status ts_parcel_add(struct ts_parcel *parcel, const void *bytes, size_t n)
{
	unsigned char *to = ts_parcel_extend(parcel, n);

	if (!to)
		return TS_NOMEM;
	if (n)
		memcpy(to, bytes, n);
	return TS_OK;
}

void ts_parcel_release(struct ts_parcel *parcel)
{
	ts_free(parcel->data);
	*parcel = (struct ts_parcel){ 0 };
}

void ts_world_most(struct ts_world *world, double *value, size_t n)
{
	world->counts.agreements++;
	world->call->most(world, value, n);
}

void ts_world_sum(struct ts_world *world, int64_t *number)
{
	world->counts.agreements++;
	world->call->sum(world, number);
}

void ts_world_spread(struct ts_world *world, int from, void *bytes, size_t n)
{
	world->counts.agreements++;
	if (world->rank == from) {
		world->counts.messages++;
		world->counts.bytes += (int64_t)n;
	}
	if (n)
		world->call->spread(world, from, bytes, n);
}

/* Counts the parcels for other ranks. */
static void count_parcels(struct ts_world *world, const struct ts_parcel *out)
{
	for (int r = 0; r < world->n; r++) {
		world->counts.messages += r != world->rank && out[r].n;
		world->counts.bytes += r != world->rank ? (int64_t)out[r].n : 0;
	}
}

void ts_world_swap(struct ts_world *world, const struct ts_parcel *out, struct ts_parcel *in)
{
	count_parcels(world, out);
	world->call->swap(world, out, in);
}

enum ts_status ts_world_deliver(struct ts_world *world, const struct ts_parcel *out, struct ts_parcel *in)
{
	for (int r = 0; r < world->n; r++)
		in[r].n = 0;
	world->counts.agreements++;
	count_parcels(world, out);
	TS_TRY(world->call->deliver(world, out, in));
	return ts_parcel_add(&in[world->rank], out[world->rank].data, out[world->rank].n);
}

/* The parcel of rank r is appended to `to`, on that rank only if `own` is set. */
static enum ts_status share_one(struct ts_world *world, int r, const struct ts_parcel *mine, bool own,
				struct ts_parcel *to)
{
	uint64_t n = mine->n;
	unsigned char *at = mine->data;

	ts_world_spread(world, r, &n, sizeof n);
	if (own || r != world->rank)
		at = ts_parcel_extend(to, n);
	if (!at && n)
		return TS_NOMEM;
	if (at != mine->data && r == world->rank && n)
		memcpy(at, mine->data, n);
	ts_world_spread(world, r, at, n);
	return TS_OK;
}

enum ts_status ts_world_share(struct ts_world *world, const struct ts_parcel *mine, struct ts_parcel *all)
{
	for (int r = 0; r < world->n; r++)
		TS_TRY(share_one(world, r, mine, true, all));
	return TS_OK;
}

enum ts_status ts_world_share_others(struct ts_world *world, const struct ts_parcel *mine,
				     struct ts_parcel *others)
{
	for (int r = 0; r < world->n; r++)
		TS_TRY(share_one(world, r, mine, false, others));
	return TS_OK;
}
