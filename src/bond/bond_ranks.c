#include "bond/bond_ranks.h"

#include <string.h>

#include "base/sort.h"
#include "bond/bonds.h"
#include "particle/copies.h"
#include "particle/identity.h"
#include "particle/particles.h"

#include "base/banned.h"

size_t ts_bonds_count(const struct ts_bonds *b)
{
	return b->ranks.divided ? (size_t)b->ranks.all : b->n;
}

/* ---- the bonds of a rank */

/* All ranks have all bonds. */
static enum ts_status begin_division(struct ts_bonds *b)
{
	struct ts_bond_ranks *r = &b->ranks;

	TS_TRY(TS_GROW(r->number, r->number_capacity, b->n));
	for (size_t k = 0; k < b->n; k++)
		r->number[k] = (uint32_t)k;
	r->divided = true;
	r->all = (int64_t)b->n;
	r->broken = b->broken;
	r->events = b->nevents;
	return TS_OK;
}

/* Row of the particle, own or copy; -1: neither. */
static int32_t row_of(const struct tsim *sim, const struct ts_identities *own,
		      const struct ts_copy_map *copies, int32_t tag)
{
	int32_t row = ts_identity_row(own, tag);

	if (row < 0)
		row = ts_copy_map_find(copies, tag);
	else
		return row;
	return row < 0 ? -1 : row + (int32_t)sim->particles->n;
}

static void find_rows(const struct tsim *sim, struct ts_bonds *b, const struct ts_identities *own,
		      const struct ts_copy_map *copies, unsigned char *drop)
{
	const int32_t n = (int32_t)sim->particles->n;

	for (size_t k = 0; k < b->n; k++) {
		for (int s = 0; s < 2; s++)
			b->row[k][s] = row_of(sim, own, copies, b->tag[k][s]);
		drop[k] = b->row[k][0] < 0 || b->row[k][1] < 0 || (b->row[k][0] >= n && b->row[k][1] >= n);
	}
}

enum ts_status ts_bonds_connect_own(struct tsim *sim, struct ts_bonds *b)
{
	struct ts_copy_map copies;
	struct ts_identities own;
	unsigned char *drop;

	if (!b->ranks.divided && begin_division(b) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(ts_identities(sim, false, &own));
	if (ts_copy_map_make(sim, &copies) != TS_OK)
		return ts_nomem(&sim->error);
	drop = ts_alloc(b->n, 1);
	if (drop) {
		find_rows(sim, b, &own, &copies, drop);
		ts_bonds_delete(b, drop);
	}
	ts_free(drop);
	ts_copy_map_release(&copies);
	return drop ? TS_OK : ts_nomem(&sim->error);
}

/* Partners that this rank has no copy of, however far away they are. */
enum ts_status ts_bonds_claim(struct ts_instance *self, struct tsim *sim, const struct ts_copy_map *copies,
			      struct ts_claims *claims)
{
	const struct ts_bonds *b = self->state;
	struct ts_identities own;

	claims->any |= b->ranks.divided || b->n;
	TS_TRY(ts_identities(sim, false, &own));
	for (size_t k = 0; k < b->n; k++) {
		bool is_own[2] = { ts_identity_row(&own, b->tag[k][0]) >= 0,
				   ts_identity_row(&own, b->tag[k][1]) >= 0 };
		int32_t partner = b->tag[k][is_own[0]];

		if (is_own[0] != is_own[1] && ts_copy_map_find(copies, partner) < 0)
			TS_TRY(ts_claims_add(sim, claims, partner));
	}
	return TS_OK;
}

/* ---- bonds that go to other ranks */

static size_t row_bytes(const struct ts_bond_column *column, size_t n)
{
	size_t bytes = 0;

	for (size_t k = 0; k < n; k++)
		bytes += column[k].size;
	return bytes;
}

static enum ts_status add_row(const struct ts_bond_column *column, size_t n, size_t b, int32_t tag,
			      struct ts_carried *out)
{
	unsigned char *to = ts_carried_add(out, tag);

	if (!to)
		return TS_NOMEM;
	for (size_t k = 0; k < n; k++) {
		memcpy(to, (const char *)column[k].data + b * column[k].size, column[k].size);
		to += column[k].size;
	}
	return TS_OK;
}

/* A bond goes with both of its particles; if all ranks get it, with its first one. */
static enum ts_status give(struct ts_instance *self, struct tsim *sim, bool results,
			   const struct ts_leaving *leaving, struct ts_carried *out)
{
	struct ts_bonds *b = self->state;
	struct ts_bond_column column[TS_BOND_COLUMNS];
	size_t n = ts_bond_columns(b, column);
	struct ts_identities own;

	out->bytes = row_bytes(column, n);
	TS_TRY(ts_identities(sim, false, &own));
	for (size_t k = 0; k < b->n; k++)
		for (int s = 0; s < (results ? 1 : 2); s++) {
			int32_t tag = b->tag[k][s];

			if (leaving ? !ts_carried_leaves(leaving, tag) : ts_identity_row(&own, tag) < 0)
				continue;
			if (add_row(column, n, k, tag, out) != TS_OK)
				return ts_nomem(&sim->error);
		}
	if (!leaving)
		b->n = 0;
	return TS_OK;
}

/* Sorts the bonds as they were before they were divided; of those that came with both of their particles, or were here
 * before, one is kept. */
static enum ts_status sort_by_number(struct ts_bonds *b)
{
	uint64_t *key = ts_alloc(2 * b->n, sizeof *key);
	unsigned char *twice = ts_alloc(b->n, 1);
	enum ts_status status = key && twice ? TS_OK : TS_NOMEM;

	for (size_t k = 0; status == TS_OK && k < b->n; k++)
		key[k] = (uint64_t)b->ranks.number[k] << 32 | k;
	if (status == TS_OK) {
		ts_sort_keys(key, key + b->n, b->n);
		status = ts_bonds_reorder(b, key);
	}
	for (size_t k = 1; status == TS_OK && k < b->n; k++)
		twice[k] = b->ranks.number[k] == b->ranks.number[k - 1];
	if (status == TS_OK)
		ts_bonds_delete(b, twice);
	ts_free(key);
	ts_free(twice);
	return status;
}

static enum ts_status append_rows(struct tsim *sim, struct ts_bonds *b, const struct ts_carried *rows)
{
	struct ts_bond_column column[TS_BOND_COLUMNS];
	size_t more = ts_carried_count(rows), n;

	TS_TRY(ts_bonds_reserve(sim, b->n + more));
	n = ts_bond_columns(b, column);
	for (size_t k = 0; k < more; k++) {
		int32_t tag;
		const unsigned char *from = ts_carried_row(rows, k, &tag);

		for (size_t c = 0; c < n; c++) {
			memcpy((char *)column[c].data + b->n * column[c].size, from, column[c].size);
			from += column[c].size;
		}
		b->n++;
	}
	return TS_OK;
}

/* Without ranks.divided the list is whole, and no row comes. */
static enum ts_status take(struct ts_instance *self, struct tsim *sim, const struct ts_carried *rows)
{
	struct ts_bonds *b = self->state;

	if (!b->ranks.divided)
		return TS_OK;
	if (ts_carried_count(rows)) {
		TS_TRY(append_rows(sim, b, rows));
		if (sort_by_number(b) != TS_OK)
			return ts_nomem(&sim->error);
	}
	b->ranks.divided = sim->division != NULL;
	return TS_OK;
}

const struct ts_carrier ts_bonds_carrier = { .give = give, .take = take };

/* ---- numbers and events of all ranks */

struct row {
	struct ts_bond_event event;
	double energy;
	uint32_t number;
};

/* In the order in which one rank records them: by steps, in a step bonds that are too hot first, then by bonds. */
static int compare_rows(const void *a, const void *b)
{
	const struct row *p = a, *q = b;
	int hot = (p->event.mode == TS_BOND_HEATED) - (q->event.mode == TS_BOND_HEATED);

	if (p->event.step != q->event.step)
		return p->event.step < q->event.step ? -1 : 1;
	return hot ? -hot : (p->number > q->number) - (p->number < q->number);
}

enum ts_status ts_bonds_note_event(struct ts_bonds *b, size_t bond)
{
	struct ts_bond_ranks *r = &b->ranks;

	if (!r->divided)
		return TS_OK;
	TS_TRY(TS_GROW(r->event_number, r->event_capacity, b->nevents - r->events));
	r->event_number[b->nevents - r->events - 1] = r->number[bond];
	return TS_OK;
}

static enum ts_status pack_events(const struct ts_bonds *b, struct ts_parcel *out)
{
	for (size_t k = b->ranks.events; k < b->nevents; k++) {
		struct row row;

		memset(&row, 0, sizeof row);
		row.event = b->event[k];
		row.energy = b->event_energy[k];
		row.number = b->ranks.event_number[k - b->ranks.events];
		TS_TRY(ts_parcel_add(out, &row, sizeof row));
	}
	return TS_OK;
}

static enum ts_status unpack_events(struct tsim *sim, struct ts_bonds *b, const struct ts_parcel *all)
{
	size_t n = all->n / sizeof(struct row);
	struct row *row = ts_alloc(n, sizeof *row);
	enum ts_status status = row ? ts_bonds_reserve_events(sim, b->ranks.events + n) : TS_NOMEM;

	if (status == TS_OK && n) {
		memcpy(row, all->data, n * sizeof *row);
		ts_sort(row, n, sizeof *row, compare_rows);
	}
	b->nevents = b->ranks.events;
	for (size_t k = 0; status == TS_OK && k < n; k++) {
		b->event[b->nevents] = row[k].event;
		b->event_energy[b->nevents++] = row[k].energy;
	}
	ts_free(row);
	return status;
}

static enum ts_status join_events(struct tsim *sim, struct ts_bonds *b)
{
	struct ts_parcel mine = { 0 }, all = { 0 };
	enum ts_status status = pack_events(b, &mine);

	if (status == TS_OK)
		status = ts_world_share(sim->world, &mine, &all);
	if (status == TS_OK)
		status = unpack_events(sim, b, &all);
	ts_parcel_release(&mine);
	ts_parcel_release(&all);
	b->ranks.events = b->nevents;
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_bonds_join(struct ts_instance *self, struct tsim *sim)
{
	struct ts_bonds *b = self->state;
	struct ts_bond_ranks *r = &b->ranks;
	enum { ALL, BROKEN, NUMBERS };
	int64_t number[NUMBERS] = { [BROKEN] = b->broken - r->broken };

	if (!r->divided)
		return TS_OK;
	for (size_t k = 0; k < b->n; k++)
		number[ALL] += (size_t)b->row[k][0] < sim->particles->n;
	ts_world_sums(sim->world, number, NUMBERS);
	b->broken = r->broken += number[BROKEN];
	b->gone += r->all - number[ALL] - number[BROKEN];
	r->all = number[ALL];
	return number[BROKEN] ? join_events(sim, b) : TS_OK;
}
