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
	ts_world_sums(world, number, 1);
}

void ts_world_sums(struct ts_world *world, int64_t *number, size_t n)
{
	world->counts.agreements++;
	world->call->sum(world, number, n);
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

void ts_world_sizes(struct ts_world *world, uint64_t n, uint64_t *size)
{
	world->counts.agreements++;
	world->call->sizes(world, n, size);
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

/* Appends the parcels of all ranks; *own: where that of this rank begins in `all`. */
static enum ts_status share(struct ts_world *world, const struct ts_parcel *mine, const uint64_t *size,
			    struct ts_parcel *all, size_t *own)
{
	size_t n = 0, first = all->n;
	unsigned char *to;

	for (int r = 0; r < world->n; r++) {
		if (r == world->rank)
			*own = first + n;
		n += size[r];
	}
	to = ts_parcel_extend(all, n);
	return to ? world->call->collect(world, mine->data, size, to) : TS_NOMEM;
}

static enum ts_status find_sizes_and_share(struct ts_world *world, const struct ts_parcel *mine,
					   struct ts_parcel *all, size_t *own)
{
	uint64_t *size = ts_alloc((size_t)world->n, sizeof *size);
	enum ts_status status = TS_NOMEM;

	world->counts.agreements++;
	world->counts.messages++;
	world->counts.bytes += (int64_t)mine->n;
	if (size) {
		ts_world_sizes(world, mine->n, size);
		status = share(world, mine, size, all, own);
	}
	ts_free(size);
	return status;
}

enum ts_status ts_world_share(struct ts_world *world, const struct ts_parcel *mine, struct ts_parcel *all)
{
	size_t own = 0;

	return find_sizes_and_share(world, mine, all, &own);
}

enum ts_status ts_world_share_own(struct ts_world *world, const struct ts_parcel *mine, struct ts_parcel *all,
				  size_t *own)
{
	return find_sizes_and_share(world, mine, all, own);
}

enum ts_status ts_world_share_others(struct ts_world *world, const struct ts_parcel *mine,
				     struct ts_parcel *others)
{
	size_t own = 0;

	TS_TRY(find_sizes_and_share(world, mine, others, &own));
	others->n -= mine->n;
	memmove(others->data + own, others->data + own + mine->n, others->n - own);
	return TS_OK;
}

enum ts_status ts_world_share_known(struct ts_world *world, const struct ts_parcel *mine,
				    const uint64_t *size, struct ts_parcel *all)
{
	size_t own = 0;

	world->counts.agreements++;
	world->counts.messages += mine->n > 0;
	world->counts.bytes += (int64_t)mine->n;
	return share(world, mine, size, all, &own);
}
