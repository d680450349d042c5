#include "core/block_work.h"

#include <string.h>

#include "base/parallel.h"
#include "core/ranks.h"

#include "base/banned.h"

/* Blocks that threads convert at the same time. */
struct turn {
	const struct ts_block_work *work;
	const unsigned char *data; /* of the first one */
	size_t n;		   /* bytes of all that follow */
	struct ts_str *slot;	   /* what becomes of each */
};

static void convert_blocks(void *context, size_t from, size_t to)
{
	const struct turn *t = context;
	const struct ts_block_work *w = t->work;

	for (size_t k = from; k < to; k++) {
		const size_t at = k * w->block, left = t->n - at;
		struct ts_str slot = t->slot[k]; /* not beside that of another thread in memory */

		ts_str_clear(&slot);
		w->convert(w->context, t->data + at, left < w->block ? left : w->block, &slot);
		t->slot[k] = slot;
	}
}

static enum ts_status convert_turn(struct turn *t, size_t blocks, struct ts_str *out, uint64_t *length)
{
	ts_parallel((int)blocks, blocks, convert_blocks, t);
	for (size_t k = 0; k < blocks; k++) {
		if (t->slot[k].failed)
			return TS_NOMEM;
		ts_str_add_n(out, ts_str_text(&t->slot[k]), t->slot[k].length);
		length[k] = t->slot[k].length;
	}
	return out->failed ? TS_NOMEM : TS_OK;
}

/* By this rank alone. */
static enum ts_status convert_alone(const struct tsim *sim, const struct ts_block_work *w,
				    const unsigned char *data, size_t n, struct ts_str *out, uint64_t *length)
{
	const size_t blocks = ts_block_work_blocks(w, n), team = (size_t)sim->threads;
	const size_t most = blocks < team ? blocks : team;
	struct ts_str *slot = ts_alloc(most, sizeof *slot);
	enum ts_status status = slot ? TS_OK : TS_NOMEM;

	for (size_t k = 0; k < blocks && status == TS_OK; k += most) {
		struct turn turn = { w, data + k * w->block, n - k * w->block, slot };

		status = convert_turn(&turn, blocks - k < most ? blocks - k : most, out, length + k);
	}
	for (size_t k = 0; slot && k < most; k++)
		ts_str_release(&slot[k]);
	ts_free(slot);
	return status;
}

/* ---- several ranks */

/* What goes to each rank and comes from it. */
struct exchange {
	const struct ts_block_work *work;
	struct ts_world *world;
	struct ts_parcel *out, *in; /* [ranks] */
	size_t n;		    /* bytes of all blocks */
	size_t share;		    /* of a rank in a turn, bytes */
};

static enum ts_status deliver(const struct exchange *e)
{
	for (int r = 0; r < e->world->n; r++)
		e->in[r].n = 0;
	TS_TRY(ts_world_deliver(e->world, e->out, e->in));
	for (int r = 0; r < e->world->n; r++)
		e->out[r].n = 0;
	return TS_OK;
}

/* The bytes from .. to - 1 of rank r in the turn that begins with byte `at`. */
static void part_of_rank(const struct exchange *e, size_t at, int r, size_t *from, size_t *to)
{
	const size_t first = at + (size_t)r * e->share;

	*from = first < e->n ? first : e->n;
	*to = *from + e->share < e->n ? *from + e->share : e->n;
}

static enum ts_status send_parts(const struct exchange *e, const unsigned char *data, size_t at)
{
	size_t from, to;

	for (int r = 1; r < e->world->n && e->world->rank == 0; r++) {
		part_of_rank(e, at, r, &from, &to);
		TS_TRY(ts_parcel_add(&e->out[r], data + from, to - from));
	}
	return deliver(e);
}

/* Lengths of the blocks, and the blocks, for the first rank. */
static enum ts_status answer(const struct exchange *e, const struct tsim *sim, uint64_t *length)
{
	const struct ts_parcel *part = &e->in[0];
	struct ts_str done = { 0 };
	enum ts_status status = convert_alone(sim, e->work, part->data, part->n, &done, length);

	if (status == TS_OK)
		status = ts_parcel_add(&e->out[0], length,
				       ts_block_work_blocks(e->work, part->n) * sizeof *length);
	if (status == TS_OK)
		status = ts_parcel_add(&e->out[0], ts_str_text(&done), done.length);
	ts_str_release(&done);
	return status;
}

static enum ts_status take_answers(const struct exchange *e, size_t at, struct ts_str *out, uint64_t *length)
{
	size_t from, to;

	for (int r = 1; r < e->world->n; r++) {
		const struct ts_parcel *in = &e->in[r];
		size_t bytes;

		part_of_rank(e, at, r, &from, &to);
		bytes = ts_block_work_blocks(e->work, to - from) * sizeof *length;
		if (!bytes)
			continue;
		memcpy(length + from / e->work->block, in->data, bytes);
		ts_str_add_n(out, (const char *)in->data + bytes, in->n - bytes);
	}
	return out->failed ? TS_NOMEM : TS_OK;
}

/* A turn of all ranks. */
static enum ts_status convert_parts(const struct exchange *e, const struct tsim *sim,
				    const unsigned char *data, size_t at, struct ts_str *out,
				    uint64_t *length)
{
	size_t from, to;

	TS_TRY(send_parts(e, data, at));
	if (e->world->rank > 0) {
		TS_TRY(answer(e, sim, length));
		return deliver(e);
	}
	part_of_rank(e, at, 0, &from, &to);
	TS_TRY(convert_alone(sim, e->work, data + from, to - from, out, length + from / e->work->block));
	TS_TRY(deliver(e));
	return take_answers(e, at, out, length);
}

static enum ts_status convert_divided(struct tsim *sim, const struct ts_block_work *w, const void *data,
				      size_t n, struct ts_str *out, uint64_t *length)
{
	const size_t ranks = (size_t)sim->world->n, each = (ts_block_work_blocks(w, n) + ranks - 1) / ranks;
	const size_t share = (each < w->sent ? each : w->sent) * w->block;
	struct ts_parcel *parcel = ts_alloc(2 * ranks, sizeof *parcel);
	const struct exchange e = { w, sim->world, parcel, parcel + ranks, n, share };
	enum ts_status status = parcel ? TS_OK : TS_NOMEM;

	for (size_t at = 0; at < n && status == TS_OK; at += ranks * share)
		status = convert_parts(&e, sim, data, at, out, length);
	for (size_t r = 0; parcel && r < 2 * ranks; r++)
		ts_parcel_release(&parcel[r]);
	ts_free(parcel);
	return status;
}

enum ts_status ts_block_work(struct tsim *sim, const struct ts_block_work *w, const void *data, size_t n,
			     struct ts_str *out, uint64_t *length)
{
	enum ts_status status = TS_OK;

	if (sim->world && ts_block_work_blocks(w, n) > 1)
		status = convert_divided(sim, w, data, n, out, length);
	else if (ts_ranks_first(sim))
		status = convert_alone(sim, w, data, n, out, length);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}
