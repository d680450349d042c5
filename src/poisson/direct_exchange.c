#include "poisson/direct_exchange.h"

#include <string.h>

#include "base/banned.h"

struct range {
	size_t from, to;
};

static struct range planes_of(const struct ts_direct *s, int rank)
{
	return (struct range){ ts_slabs_part(s->slabs, rank, (size_t)s->n[2]),
			       ts_slabs_part(s->slabs, rank + 1, (size_t)s->n[2]) };
}

/* Modes of its strips. */
static struct range modes_of(const struct ts_direct *s, int rank)
{
	const size_t modes = (size_t)s->n[0] * (size_t)s->n[1], width = s->strip;
	const size_t strips = (modes + width - 1) / width;
	const size_t from = width * ts_slabs_part(s->slabs, rank, strips),
		     to = width * ts_slabs_part(s->slabs, rank + 1, strips);

	return (struct range){ from < modes ? from : modes, to < modes ? to : modes };
}

static size_t numbers(struct range planes, struct range modes)
{
	return (planes.to - planes.from) * (modes.to - modes.from);
}

/* Room for what goes to each rank and comes from it, both ways. */
static enum ts_status make_room(const struct ts_direct *s, struct ts_slabs *slabs)
{
	const int ranks = slabs->world->n, own = slabs->world->rank;

	for (int r = 0; r < 2 * ranks; r++) {
		const size_t there = numbers(planes_of(s, own), modes_of(s, r % ranks)),
			     here = numbers(planes_of(s, r % ranks), modes_of(s, own));
		struct ts_parcel *parcel = &slabs->packed[r];

		parcel->n = 0;
		if (!ts_parcel_extend(parcel, (there > here ? there : here) * sizeof(double)))
			return TS_NOMEM;
	}
	return TS_OK;
}

enum ts_status ts_direct_divide(struct ts_direct *s, struct ts_slabs *slabs)
{
	const bool was = slabs && slabs->active;
	enum ts_status status;

	s->slabs =
		slabs && slabs->world && s->axis[2] == 2 && s->n[1] > 1 && s->n[2] == slabs->n ? slabs : NULL;
	if (!s->slabs)
		return TS_OK;
	slabs->active = true; /* as it will be */
	status = make_room(s, slabs);
	slabs->active = was;
	return status;
}

bool ts_direct_divided(const struct ts_direct *s)
{
	return ts_slabs_ranks(s->slabs) > 1;
}

/* Copies modes in planes to a parcel, or from it. */
static void pack(const struct ts_direct *s, struct range planes, struct range modes, struct ts_parcel *parcel)
{
	const size_t bytes = (modes.to - modes.from) * sizeof *s->work;
	unsigned char *to = parcel->data;

	for (size_t k = planes.from; k < planes.to; k++, to += bytes)
		memcpy(to, s->work + k * s->plane + modes.from, bytes);
	parcel->n = (planes.to - planes.from) * bytes;
}

static void unpack(const struct ts_direct *s, struct range planes, struct range modes,
		   const struct ts_parcel *parcel)
{
	const size_t bytes = (modes.to - modes.from) * sizeof *s->work;
	const unsigned char *from = parcel->data;

	for (size_t k = planes.from; k < planes.to; k++, from += bytes)
		memcpy(s->work + k * s->plane + modes.from, from, bytes);
}

void ts_direct_exchange(const struct ts_direct *s, bool back)
{
	const int ranks = ts_slabs_ranks(s->slabs), own = ranks > 1 ? s->slabs->world->rank : 0;
	struct range planes, modes;
	struct ts_parcel *out, *in;

	if (ranks == 1)
		return;
	planes = planes_of(s, own);
	modes = modes_of(s, own);
	out = s->slabs->packed;
	in = out + ranks;
	for (int r = 0; r < ranks; r++) {
		const struct range there = back ? planes_of(s, r) : planes,
				   those = back ? modes : modes_of(s, r);
		const struct range here = back ? planes : planes_of(s, r),
				   these = back ? modes_of(s, r) : modes;

		out[r].n = in[r].n = 0;
		if (r == own)
			continue;
		pack(s, there, those, &out[r]);
		in[r].n = numbers(here, these) * sizeof *s->work;
	}
	ts_world_swap(s->slabs->world, out, in);
	for (int r = 0; r < ranks; r++)
		if (r != own)
			unpack(s, back ? planes : planes_of(s, r), back ? modes_of(s, r) : modes, &in[r]);
}
