#include "bond/bond_rows.h"

#include <string.h>

#include "base/parallel.h"
#include "bond/bonds.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { LANES = TS_BOND_ROW_LANES };

size_t ts_bond_share_begin(const struct ts_bond_rows *rows, size_t k)
{
	return rows->chunks * k / (size_t)rows->shares;
}

size_t ts_bond_chunk_end(const struct ts_bond_rows *rows, size_t c)
{
	return c + 1 < rows->chunks ? (c + 1) * TS_BOND_CHUNK : rows->particles;
}

struct listing {
	struct ts_bonds *bonds;
	uint32_t *slot_of; /* by entry of the gather, 2 bond + side */
	uint32_t *free;	   /* by lane of all rows: slots that may be used again */
	size_t *used;	   /* by share: number of slots */
};

static size_t partner_of(const struct ts_bonds *b, uint32_t entry)
{
	return (size_t)b->row[entry >> 1][!(entry & 1)];
}

/* Whether particle i of the share that begins with particle `begin` is the first to need the bond. */
static bool computed_at(const struct ts_bonds *b, uint32_t entry, size_t i, size_t begin)
{
	size_t partner = partner_of(b, entry);

	return partner > i || partner < begin;
}

/* ---- how many rows each chunk has */

static void count_rows(void *context, size_t from, size_t to)
{
	const struct listing *t = context;
	const struct ts_bonds *b = t->bonds;
	const struct ts_gather *g = &b->gather;

	for (size_t share = from; share < to; share++) {
		size_t c = ts_bond_share_begin(&b->rows, share),
		       end = ts_bond_share_begin(&b->rows, share + 1);
		const size_t begin = c * TS_BOND_CHUNK;

		for (; c < end; c++) {
			size_t n = 0;

			for (size_t i = c * TS_BOND_CHUNK; i < ts_bond_chunk_end(&b->rows, c); i++)
				for (size_t k = g->first[i]; k < g->first[i + 1]; k++)
					n += computed_at(b, g->entry[k], i, begin);
			b->rows.first[c + 1] = (n + LANES - 1) / LANES;
		}
	}
}

/* ---- lanes and slots */

/* What is free and used in a share. */
struct slots {
	uint32_t *free;
	size_t nfree, used;
};

static uint32_t take_slot(struct slots *s)
{
	return s->nfree ? s->free[--s->nfree] : (uint32_t)s->used++;
}

static void clear_row(struct ts_bond_row *r, size_t particle)
{
	for (int k = 0; k < LANES; k++) {
		r->particle[0][k] = r->particle[1][k] = (int32_t)particle;
		r->bond[k] = TS_BOND_NONE;
		r->slot[k] = 0;
	}
}

/* Puts the bonds that chunk c needs first into its rows, each with a slot. */
static void list_lanes(const struct listing *t, size_t c, size_t begin, size_t end, struct slots *s)
{
	const struct ts_bonds *b = t->bonds;
	const struct ts_gather *g = &b->gather;
	struct ts_bond_row *row = b->rows.row + b->rows.first[c];
	size_t n = 0;

	for (size_t r = b->rows.first[c]; r < b->rows.first[c + 1]; r++)
		clear_row(&b->rows.row[r], c * TS_BOND_CHUNK);
	for (size_t i = c * TS_BOND_CHUNK; i < ts_bond_chunk_end(&b->rows, c); i++)
		for (size_t k = g->first[i]; k < g->first[i + 1]; k++) {
			uint32_t entry = g->entry[k], slot;
			struct ts_bond_row *r = &row[n / LANES];

			if (!computed_at(b, entry, i, begin))
				continue;
			slot = take_slot(s);
			t->slot_of[entry] = slot;
			if (partner_of(b, entry) >= begin && partner_of(b, entry) < end)
				t->slot_of[entry ^ 1] = slot;
			for (int side = 0; side < 2; side++)
				r->particle[side][n % LANES] = b->row[entry >> 1][side];
			r->bond[n % LANES] = entry >> 1;
			r->slot[n++ % LANES] = slot;
		}
}

/* Lists what the particles of chunk c sum, and frees the slots that no later particle needs. */
static void list_sums(const struct listing *t, size_t c, size_t begin, size_t end, struct slots *s)
{
	const struct ts_bonds *b = t->bonds;
	const struct ts_gather *g = &b->gather;

	for (size_t i = c * TS_BOND_CHUNK; i < ts_bond_chunk_end(&b->rows, c); i++)
		for (size_t k = g->first[i]; k < g->first[i + 1]; k++) {
			uint32_t entry = g->entry[k], slot = t->slot_of[entry];
			size_t partner = partner_of(b, entry);

			b->rows.sum[k] = 2 * slot | (entry & 1);
			if (partner < i || partner < begin || partner >= end)
				s->free[s->nfree++] = slot;
		}
}

/* In the order in which the loop computes and sums. */
static void list_shares(void *context, size_t from, size_t to)
{
	const struct listing *t = context;
	const struct ts_bond_rows *rows = &t->bonds->rows;

	for (size_t share = from; share < to; share++) {
		size_t chunk = ts_bond_share_begin(rows, share),
		       chunk_end = ts_bond_share_begin(rows, share + 1);
		struct slots s = { t->free + LANES * rows->first[chunk], 0, 1 };
		const size_t begin = chunk * TS_BOND_CHUNK,
			     end = chunk_end > chunk ? ts_bond_chunk_end(rows, chunk_end - 1) : begin;

		for (size_t c = chunk; c < chunk_end; c++) {
			list_lanes(t, c, begin, end, &s);
			list_sums(t, c, begin, end, &s);
		}
		t->used[share] = s.used;
	}
}

/* The slots of a share follow those of the share before; returns the number of all. */
static size_t offset_slots(const struct listing *t)
{
	const struct ts_bond_rows *rows = &t->bonds->rows;
	const struct ts_gather *g = &t->bonds->gather;
	size_t n = 0;

	for (size_t share = 0; share < (size_t)rows->shares; share++) {
		size_t chunk = ts_bond_share_begin(rows, share),
		       chunk_end = ts_bond_share_begin(rows, share + 1);

		for (size_t r = rows->first[chunk]; n && r < rows->first[chunk_end]; r++)
			for (int k = 0; k < LANES; k++)
				rows->row[r].slot[k] += (uint32_t)n;
		for (size_t c = chunk; n && c < chunk_end; c++)
			for (size_t k = g->first[c * TS_BOND_CHUNK]; k < g->first[ts_bond_chunk_end(rows, c)];
			     k++)
				rows->sum[k] += (uint32_t)(2 * n);
		n += t->used[share];
	}
	return n;
}

/* ---- all */

static enum ts_status list_rows(struct listing *t)
{
	struct ts_bonds *b = t->bonds;
	struct ts_bond_rows *rows = &b->rows;

	TS_TRY(TS_RENEW(rows->first, rows->first_capacity, rows->chunks + 1));
	rows->first[0] = 0;
	ts_parallel(rows->shares, (size_t)rows->shares, count_rows, t);
	for (size_t c = 0; c < rows->chunks; c++)
		rows->first[c + 1] += rows->first[c];
	rows->n = rows->first[rows->chunks];
	t->slot_of = ts_alloc(2 * b->n, sizeof *t->slot_of);
	t->free = ts_alloc(LANES * rows->n, sizeof *t->free);
	t->used = ts_alloc((size_t)rows->shares, sizeof *t->used);
	if (!t->slot_of || !t->free || !t->used)
		return TS_NOMEM;
	TS_TRY(TS_RENEW(rows->row, rows->row_capacity, rows->n));
	TS_TRY(TS_RENEW(rows->sections, rows->sections_capacity, rows->n));
	TS_TRY(TS_RENEW(rows->sections_of, rows->sections_of_capacity, rows->n));
	TS_TRY(TS_RENEW(rows->sum, rows->sum_capacity, 2 * b->n));
	ts_parallel(rows->shares, (size_t)rows->shares, list_shares, t);
	return TS_RENEW(rows->result, rows->result_capacity, offset_slots(t));
}

enum ts_status ts_bond_rows_build(const struct tsim *sim, struct ts_bonds *bonds)
{
	struct listing t = { .bonds = bonds };
	struct ts_bond_rows *rows = &bonds->rows;
	enum ts_status status;

	rows->particles = sim->particles->n;
	rows->chunks = bonds->n ? (rows->particles + TS_BOND_CHUNK - 1) / TS_BOND_CHUNK : 0;
	rows->shares = ts_team(sim, bonds->n);
	rows->filled = false;
	status = list_rows(&t);
	ts_free(t.slot_of);
	ts_free(t.free);
	ts_free(t.used);
	return status;
}

void ts_bond_rows_release(struct ts_bond_rows *rows)
{
	ts_free(rows->first);
	ts_free(rows->row);
	ts_free(rows->sections);
	ts_free(rows->sections_of);
	ts_free(rows->dashpots);
	ts_free(rows->soft);
	ts_free(rows->sum);
	ts_free(rows->result);
	*rows = (struct ts_bond_rows){ 0 };
}
