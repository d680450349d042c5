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

void ts_world_swap(struct ts_world *world, const struct ts_parcel *out, struct ts_parcel *in)
{
	for (int r = 0; r < world->n; r++) {
		world->counts.messages += r != world->rank && out[r].n;
		world->counts.bytes += r != world->rank ? (int64_t)out[r].n : 0;
	}
	world->call->swap(world, out, in);
}

enum ts_status ts_world_deliver(struct ts_world *world, const struct ts_parcel *out, struct ts_parcel *in)
{
	uint64_t *size = ts_alloc((size_t)world->n, sizeof *size);
	enum ts_status status = size ? TS_OK : TS_NOMEM;

	if (!size)
		return status;
	for (int r = 0; r < world->n; r++)
		size[r] = out[r].n;
	world->counts.agreements++;
	world->call->transpose(world, size);
	for (int r = 0; r < world->n && status == TS_OK; r++) {
		in[r].n = 0;
		if (!ts_parcel_extend(&in[r], r == world->rank ? 0 : size[r]))
			status = TS_NOMEM;
	}
	if (status == TS_OK)
		ts_world_swap(world, out, in);
	if (status == TS_OK)
		status = ts_parcel_add(&in[world->rank], out[world->rank].data, out[world->rank].n);
	ts_free(size);
	return status;
}

enum ts_status ts_world_share(struct ts_world *world, const struct ts_parcel *mine, struct ts_parcel *all)
{
	for (int r = 0; r < world->n; r++) {
		uint64_t n = mine->n;
		unsigned char *to;

		ts_world_spread(world, r, &n, sizeof n);
		to = ts_parcel_extend(all, n);
		if (!to)
			return TS_NOMEM;
		if (r == world->rank && n)
			memcpy(to, mine->data, n);
		ts_world_spread(world, r, to, n);
	}
	return TS_OK;
}
