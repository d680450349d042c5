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

static size_t layers_of(const struct ts_transposition *t)
{
	return t->layers ? t->layers : 1;
}

static size_t numbers(const struct ts_transposition *t, struct range planes, struct range columns)
{
	return layers_of(t) * (planes.to - planes.from) * (columns.to - columns.from);
}

enum ts_status ts_transposition_room(const struct ts_transposition *t)
{
	const int ranks = t->slabs->world->n, own = t->slabs->world->rank;

	for (int r = 0; r < 2 * ranks; r++) {
		const size_t there = numbers(t, planes_of(t, own), columns_of(t, r % ranks)),
			     here = numbers(t, planes_of(t, r % ranks), columns_of(t, own));
		struct ts_parcel *parcel = &t->slabs->packed[r];

		parcel->n = 0;
		if (!ts_parcel_extend(parcel, (there > here ? there : here) * sizeof(double)))
			return TS_NOMEM;
	}
	return TS_OK;
}

/* Columns in planes of all layers. */
struct block {
	double *first; /* in the first plane and layer */
	size_t stride, apart;
	size_t columns, planes, layers;
};

static struct block block_of(const struct ts_transposition *t, struct range planes, struct range columns,
			     bool turned)
{
	struct block b = { .stride = turned && t->turned ? t->turned_stride : t->field.stride,
			   .apart = turned && t->turned ? t->turned_apart : t->apart,
			   .columns = columns.to - columns.from,
			   .planes = planes.to - planes.from,
			   .layers = layers_of(t) };

	b.first = turned && t->turned ? t->turned : t->field.first + columns.from;
	b.first += planes.from * b.stride;
	return b;
}

static size_t bytes_of(const struct block *b)
{
	return b->layers * b->planes * b->columns * sizeof *b->first;
}

static void pack(const struct block *b, struct ts_parcel *parcel)
{
	const size_t bytes = b->columns * sizeof *b->first;
	unsigned char *to = parcel->data;

	for (size_t m = 0; m < b->layers; m++)
		for (size_t k = 0; k < b->planes; k++, to += bytes)
			memcpy(to, b->first + m * b->apart + k * b->stride, bytes);
	parcel->n = bytes_of(b);
}

static void unpack(const struct block *b, const struct ts_parcel *parcel)
{
	const size_t bytes = b->columns * sizeof *b->first;
	const unsigned char *from = parcel->data;

	for (size_t m = 0; m < b->layers; m++)
		for (size_t k = 0; k < b->planes; k++, from += bytes)
			memcpy(b->first + m * b->apart + k * b->stride, from, bytes);
}

static void copy(const struct block *from, const struct block *to)
{
	for (size_t m = 0; m < from->layers; m++)
		for (size_t k = 0; k < from->planes; k++)
			memcpy(to->first + m * to->apart + k * to->stride,
			       from->first + m * from->apart + k * from->stride,
			       from->columns * sizeof *from->first);
}

/* What a rank gives to rank r, and gets from it. */
static void find_blocks(const struct ts_transposition *t, int r, bool back, struct block *out,
			struct block *in)
{
	const int own = t->slabs->world->rank;
	const struct block in_planes = block_of(t, planes_of(t, own), columns_of(t, r), false),
			   in_columns = block_of(t, planes_of(t, r), columns_of(t, own), true);

	*out = back ? in_columns : in_planes;
	*in = back ? in_planes : in_columns;
}

void ts_transpose(const struct ts_transposition *t, bool back)
{
	const int ranks = t->slabs->world->n, own = t->slabs->world->rank;
	struct ts_parcel *out = t->slabs->packed, *in = out + ranks;
	struct block from, to;

	for (int r = 0; r < ranks; r++) {
		out[r].n = in[r].n = 0;
		find_blocks(t, r, back, &from, &to);
		if (r == own && t->turned)
			copy(&from, &to);
		if (r == own)
			continue;
		pack(&from, &out[r]);
		in[r].n = bytes_of(&to);
	}
	ts_world_swap(t->slabs->world, out, in);
	for (int r = 0; r < ranks; r++) {
		find_blocks(t, r, back, &from, &to);
		if (r != own)
			unpack(&to, &in[r]);
	}
}
