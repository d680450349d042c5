#include "neigh/row_slots.h"

#include <string.h>

#include "base/parallel.h"
#include "particles/particles.h"

#include "base/banned.h"

struct slots {
	struct ts_rows *rows;
	uint8_t *waiting;   /* of each row: how many of its partners have not added it */
	uint32_t *free;	    /* slots that may be used again, the last first; of each share at its first row */
	uint32_t *used;	    /* how many slots a share needs */
};

static size_t particles_end(const struct ts_rows *rows, size_t c)
{
	return c + 1 < rows->chunks ? (c + 1) * TS_ROW_CHUNK : rows->particles;
}

/* Chunk c has added its rows: slots nobody waits for are free. Returns how many there are now. */
static size_t release(const struct slots *s, size_t c, uint32_t *free, size_t n)
{
	const struct ts_gather *g = &s->rows->gather;

	for (size_t k = g->first[c * TS_ROW_CHUNK]; k < g->first[particles_end(s->rows, c)]; k++) {
		size_t r = g->entry[k] >> 1;

		if (!--s->waiting[r])
			free[n++] = s->rows->slot[r];
	}
	return n;
}

/* As the rows will be computed: see rows_share in row_loop.c. */
static void assign(const struct slots *s, size_t share)
{
	struct ts_rows *rows = s->rows;
	size_t from, to, c = 0, done, n = 0;
	uint32_t used = 0, *free;

	ts_row_range(rows, share, &from, &to);
	free = s->free + from;
	for (size_t r = from; r < to; r++) {
		s->waiting[r] = (uint8_t)(1 + ((size_t)rows->j[r] < rows->particles));
		rows->slot[r] = n ? free[--n] : used++;
		if (r + 1 < to && (r + 1 - from) % TS_ROW_TURN)
			continue;
		while ((done = ts_row_chunk_done(rows, from, r + 1, &c)) < rows->chunks)
			n = release(s, done, free, n);
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
	size_t n = 0, from, to;

	for (size_t k = 0; k < (size_t)s->rows->shares; k++) {
		ts_row_range(s->rows, k, &from, &to);
		for (size_t r = from; r < to && n; r++)
			s->rows->slot[r] += (uint32_t)n;
		n += s->used[k];
	}
	return n;
}

static enum ts_status pass_on(struct ts_rows *rows, size_t *room)
{
	struct slots s = { .rows = rows, .waiting = ts_alloc(rows->n, 1),
			   .free = ts_alloc(rows->n, sizeof *s.free),
			   .used = ts_alloc((size_t)rows->shares, sizeof *s.used) };
	enum ts_status status = s.waiting && s.free && s.used ? TS_OK : TS_NOMEM;

	if (status == TS_OK) {
		ts_parallel(rows->shares, (size_t)rows->shares, assign_shares, &s);
		*room = place_shares(&s);
	}
	ts_free(s.waiting);
	ts_free(s.free);
	ts_free(s.used);
	return status;
}

static void sum_share(void *context, size_t from, size_t to)
{
	const struct ts_rows *rows = context;
	const uint32_t *entry = rows->gather.entry;

	for (size_t k = from; k < to; k++)
		rows->sum[k] = 2 * rows->slot[entry[k] >> 1] | (entry[k] & 1);
}

static enum ts_status prepare(struct tsim *sim, struct ts_rows *rows, bool kept)
{
	size_t entries = rows->n ? rows->gather.first[rows->particles] : 0, room = rows->n;

	TS_TRY(TS_RENEW(rows->sum, rows->sum_capacity, entries));
	if (kept)
		for (size_t r = 0; r < rows->n; r++)
			rows->slot[r] = (uint32_t)r;
	else
		TS_TRY(pass_on(rows, &room));
	ts_parallel(ts_team(sim, entries), entries, sum_share, rows);
	room *= (size_t)rows->parts;
	TS_TRY(TS_RENEW(rows->result, rows->room, room));
	if (room)
		memset(rows->result, 0, room * sizeof *rows->result);
	return TS_OK;
}

enum ts_status ts_rows_prepare(struct tsim *sim, struct ts_rows *rows, bool kept)
{
	enum ts_row_results results = kept ? TS_RESULTS_KEPT : TS_RESULTS_PASSED;

	if (rows->results == results)
		return TS_OK;
	rows->parts = rows->parts ? rows->parts : 1;
	rows->shares = ts_team(sim, rows->n);
	if (prepare(sim, rows, kept) != TS_OK)
		return ts_nomem(&sim->error);
	rows->results = results;
	return TS_OK;
}
