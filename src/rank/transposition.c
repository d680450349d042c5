#include "rank/transposition.h"

#include <string.h>

#include "base/banned.h"

struct range {
	size_t from, to;
};

static struct range planes_of(const struct ts_transposition *t, int rank)
{
	const struct ts_slabs *s = t->slabs;
	const size_t more = rank == s->world->n - 1 ? (size_t)t->field.behind : 0;

	return (struct range){ ts_slabs_part(s, rank, (size_t)s->n),
			       ts_slabs_part(s, rank + 1, (size_t)s->n) + more };
}

static struct range columns_of(const struct ts_transposition *t, int rank)
{
	size_t from[2];

	t->columns(t->of, rank, from);
	return (struct range){ from[0], from[1] };
}

static size_t numbers(struct range planes, struct range columns)
{
	return (planes.to - planes.from) * (columns.to - columns.from);
}

enum ts_status ts_transposition_room(const struct ts_transposition *t)
{
	const int ranks = t->slabs->world->n, own = t->slabs->world->rank;

	for (int r = 0; r < 2 * ranks; r++) {
		const size_t there = numbers(planes_of(t, own), columns_of(t, r % ranks)),
			     here = numbers(planes_of(t, r % ranks), columns_of(t, own));
		struct ts_parcel *parcel = &t->slabs->packed[r];

		parcel->n = 0;
		if (!ts_parcel_extend(parcel, (there > here ? there : here) * sizeof(double)))
			return TS_NOMEM;
	}
	return TS_OK;
}

/* Copies columns in planes to a parcel, or from it. */
static void pack(const struct ts_slabs_field *field, struct range planes, struct range columns,
		 struct ts_parcel *parcel)
{
	const size_t bytes = (columns.to - columns.from) * sizeof *field->first;
	unsigned char *to = parcel->data;

	for (size_t k = planes.from; k < planes.to; k++, to += bytes)
		memcpy(to, field->first + k * field->stride + columns.from, bytes);
	parcel->n = (planes.to - planes.from) * bytes;
}

static void unpack(const struct ts_slabs_field *field, struct range planes, struct range columns,
		   const struct ts_parcel *parcel)
{
	const size_t bytes = (columns.to - columns.from) * sizeof *field->first;
	const unsigned char *from = parcel->data;

	for (size_t k = planes.from; k < planes.to; k++, from += bytes)
		memcpy(field->first + k * field->stride + columns.from, from, bytes);
}

void ts_transpose(const struct ts_transposition *t, bool back)
{
	const int ranks = t->slabs->world->n, own = t->slabs->world->rank;
	const struct range planes = planes_of(t, own), columns = columns_of(t, own);
	struct ts_parcel *out = t->slabs->packed, *in = out + ranks;

	for (int r = 0; r < ranks; r++) {
		const struct range there = planes_of(t, r), those = columns_of(t, r);

		out[r].n = in[r].n = 0;
		if (r == own)
			continue;
		pack(&t->field, back ? there : planes, back ? columns : those, &out[r]);
		in[r].n = (back ? numbers(planes, those) : numbers(there, columns)) * sizeof *t->field.first;
	}
	ts_world_swap(t->slabs->world, out, in);
	for (int r = 0; r < ranks; r++)
		if (r != own)
			unpack(&t->field, back ? planes : planes_of(t, r), back ? columns_of(t, r) : columns,
			       &in[r]);
}
