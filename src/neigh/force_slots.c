#include "neigh/force_slots.h"

#include <string.h>

#include "base/parallel.h"
#include "neigh/active_pairs.h"
#include "neigh/contact_memory.h"
#include "particle/particles.h"

#include "base/banned.h"

/* ---- the sums of near rows: at first of their places in the list */

static size_t particles_end(const struct ts_contact_list *rows, size_t c)
{
	return c + 1 < rows->chunks ? (c + 1) * TS_CONTACT_CHUNK : rows->particles;
}

static void count_share(void *context, size_t from, size_t to)
{
	const struct ts_contact_list *rows = context;
	const struct ts_gather *g = &rows->gather;

	for (size_t i = from; i < to; i++) {
		uint32_t n = 0;

		for (size_t k = g->first[i]; k < g->first[i + 1]; k++)
			n += rows->at[g->entry[k] >> 1] != TS_PAIR_INACTIVE;
		rows->sum_first[i + 1] = n;
	}
}

static struct ts_contact_chunk sum_chunk(const struct ts_contact_list *rows, size_t from, size_t to)
{
	const struct ts_gather *g = &rows->gather;
	struct ts_contact_chunk c = { SIZE_MAX, 0 };
	uint32_t *out = rows->sum + rows->sum_first[from];

	for (size_t k = g->first[from]; k < g->first[to]; k++) {
		uint32_t at = rows->at[g->entry[k] >> 1];

		if (at == TS_PAIR_INACTIVE)
			continue;
		*out++ = 2 * at | (g->entry[k] & 1);
		c.first = at < c.first ? at : c.first;
		c.end = at >= c.end ? at + 1 : c.end;
	}
	return c.end ? c : (struct ts_contact_chunk){ 0 };
}

static void sum_share(void *context, size_t from, size_t to)
{
	const struct ts_contact_list *rows = context;

	for (size_t c = from; c < to; c++)
		rows->chunk[c] = sum_chunk(rows, c * TS_CONTACT_CHUNK, particles_end(rows, c));
}

static enum ts_status list_sums(struct tsim *sim, struct ts_contact_list *rows)
{
	size_t n = rows->particles;

	rows->chunks = rows->n ? (n + TS_CONTACT_CHUNK - 1) / TS_CONTACT_CHUNK : 0;
	TS_TRY(TS_RENEW(rows->chunk, rows->chunk_capacity, rows->chunks));
	TS_TRY(TS_RENEW(rows->gathered, rows->gathered_capacity, rows->chunks));
	TS_TRY(TS_RENEW(rows->sum_first, rows->sum_first_capacity, n + 1));
	if (!rows->n)
		return TS_OK;
	ts_parallel(ts_team(sim, rows->n), n, count_share, rows);
	rows->sum_first[0] = 0;
	for (size_t i = 0; i < n; i++)
		rows->sum_first[i + 1] += rows->sum_first[i];
	/* never NULL: offsets are taken of it */
	TS_TRY(TS_RENEW(rows->sum, rows->sum_capacity, rows->sum_first[n] + 1));
	ts_parallel(ts_team(sim, rows->n), rows->chunks, sum_share, rows);
	return TS_OK;
}

/* ---- slots that are used again */

struct slots {
	struct ts_contact_list *rows;
	uint32_t *used; /* how many slots a share needs */
};

/* Chunk c has added its rows: slots nobody waits for are free. Returns how many there are now. */
static size_t release(const struct ts_contact_list *rows, size_t c, uint32_t *free, size_t n)
{
	size_t end = rows->sum_first[particles_end(rows, c)];

	for (size_t k = rows->sum_first[c * TS_CONTACT_CHUNK]; k < end; k++) {
		size_t at = rows->sum[k] >> 1;

		if (!--rows->waiting[at])
			free[n++] = rows->near[at].slot;
	}
	return n;
}

/* As the rows will be computed: see walk_share in contact_pass.c. */
static void assign(const struct slots *s, size_t share)
{
	struct ts_contact_list *rows = s->rows;
	const struct ts_contact_span *span = &rows->span[share];
	uint32_t used = 0, *free = rows->at + span->near; /* places have been noted in the sums */
	size_t c = 0, done, n = 0;

	for (size_t b = span->block; b < span->block_end; b++) {
		const struct ts_active_block *block = &rows->block[b];
		size_t end = (size_t)block->first + block->n;

		for (size_t at = block->first; at < end; at++) {
			rows->waiting[at] = (uint8_t)(1 + ((size_t)rows->near[at].j < rows->particles));
			rows->near[at].slot = n ? free[--n] : used++;
		}
		if (b + 1 < span->block_end && (b + 1 - span->block) % TS_BLOCKS_A_TURN)
			continue;
		while ((done = ts_contact_chunk_done(rows, span->near, end, &c)) < rows->chunks)
			n = release(rows, done, free, n);
	}
	s->used[share] = used;
}

static void assign_shares(void *context, size_t from, size_t to)
{
	for (size_t k = from; k < to; k++)
		assign(context, k);
}

/* Shares take their slots one behind the other. */
static size_t place_shares(const struct slots *s)
{
	struct ts_contact_list *rows = s->rows;
	size_t n = 0;

	for (size_t k = 0; k < (size_t)rows->shares; k++) {
		for (size_t at = rows->span[k].near; at < rows->span[k].near_end && n; at++)
			rows->near[at].slot += (uint32_t)n;
		n += s->used[k];
	}
	return n;
}

static enum ts_status pass_on(struct ts_contact_list *rows, size_t *room)
{
	struct slots s = { rows, ts_alloc((size_t)rows->shares, sizeof *s.used) };

	if (!s.used || TS_RENEW(rows->waiting, rows->waiting_capacity, rows->n) != TS_OK) {
		ts_free(s.used);
		return TS_NOMEM;
	}
	ts_parallel(rows->shares, (size_t)rows->shares, assign_shares, &s);
	*room = place_shares(&s);
	ts_free(s.used);
	return TS_OK;
}

static void slots_share(void *context, size_t from, size_t to)
{
	const struct ts_contact_list *rows = context;

	for (size_t k = from; k < to; k++)
		rows->sum[k] = 2 * rows->near[rows->sum[k] >> 1].slot | (rows->sum[k] & 1);
}

/* ---- */

/* Room for so many results, all zero. */
static enum ts_status clear(struct ts_contact_list *rows, size_t room)
{
	rows->parts = rows->parts ? rows->parts : 1;
	room *= (size_t)rows->parts;
	TS_TRY(TS_RENEW(rows->result, rows->room, room));
	if (room)
		memset(rows->result, 0, room * sizeof *rows->result);
	return TS_OK;
}

static enum ts_status prepare(struct tsim *sim, struct ts_contact_list *rows, bool kept)
{
	size_t room = rows->n, sums;

	TS_TRY(list_sums(sim, rows));
	if (!kept)
		TS_TRY(pass_on(rows, &room));
	sums = rows->n ? rows->sum_first[rows->particles] : 0;
	ts_parallel(ts_team(sim, sums), sums, slots_share, rows);
	return clear(rows, room);
}

enum ts_status ts_contact_forces_prepare(struct tsim *sim, struct ts_contact_list *rows, bool kept)
{
	enum ts_contact_results results = kept ? TS_RESULTS_KEPT : TS_RESULTS_PASSED;

	if (rows->results == results && !ts_active_pairs_outdated(rows))
		return TS_OK;
	ts_contacts_store_history(sim, rows);
	rows->looked = false; /* should it fail */
	rows->shares = ts_team(sim, rows->n);
	TS_TRY(ts_active_pairs_choose(sim, rows));
	TS_TRY(ts_contacts_load_history(sim, rows));
	if (prepare(sim, rows, kept) != TS_OK)
		return ts_nomem(&sim->error);
	rows->results = results;
	rows->looked = true;
	return TS_OK;
}

enum ts_status ts_contact_forces_keep(struct tsim *sim, struct ts_contact_list *rows)
{
	ts_contacts_store_history(sim, rows);
	rows->looked = false;
	if (clear(rows, rows->n) != TS_OK)
		return ts_nomem(&sim->error);
	rows->results = TS_RESULTS_KEPT;
	return TS_OK;
}
