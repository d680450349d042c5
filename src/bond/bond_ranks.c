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
static void begin_division(struct ts_bonds *b)
{
	struct ts_bond_ranks *r = &b->ranks;

	r->divided = true;
	r->all = (int64_t)b->n;
	r->created = b->created;
	r->broken = b->broken;
	r->events = b->nevents;
}

void ts_bonds_divide(struct tsim *sim)
{
	if (sim->division && !sim->bonds->ranks.divided)
		begin_division(sim->bonds);
}

int32_t ts_bonds_row_of(const struct tsim *sim, const struct ts_identities *own,
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
			b->row[k][s] = ts_bonds_row_of(sim, own, copies, b->tag[k][s]);
		drop[k] = b->row[k][0] < 0 || b->row[k][1] < 0 || (b->row[k][0] >= n && b->row[k][1] >= n);
	}
}

enum ts_status ts_bonds_connect_own(struct tsim *sim, struct ts_bonds *b)
{
	struct ts_copy_map copies;
	struct ts_identities own;
	unsigned char *drop;

	ts_bonds_divide(sim);
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

/* Of the bonds that came with both of their particles, or were here before, one is kept. */
static enum ts_status remove_repeated(struct ts_bonds *b)
{
	unsigned char *twice = ts_alloc(b->n, 1);

	if (!twice)
		return TS_NOMEM;
	ts_bonds_sort(b);
	for (size_t k = 1; k < b->n; k++)
		twice[k] = ts_compare_int32_pair(b->tag[k], b->tag[k - 1]) == 0;
	ts_bonds_delete(b, twice);
	ts_free(twice);
	return TS_OK;
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
		if (remove_repeated(b) != TS_OK)
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
	unsigned char fresh;
};

/* In the order in which one rank records them: by steps, in a step bonds that are too hot first, then by bonds. */
static int compare_rows(const void *a, const void *b)
{
	const struct row *p = a, *q = b;
	int hot = (p->event.mode == TS_BOND_HEATED) - (q->event.mode == TS_BOND_HEATED);

	if (p->event.step != q->event.step)
		return p->event.step < q->event.step ? -1 : 1;
	return hot ? -hot : ts_compare_int32_pair(p->event.tag, q->event.tag);
}

/* Orders events by steps, in a step those of bonds that break before the contact list is built first. */
static int compare_with(const struct ts_bond_event *e, int64_t step, const int32_t tag[2])
{
	if (e->step != step)
		return e->step < step ? -1 : 1;
	if (e->mode == TS_BOND_HEATED || e->mode == TS_BOND_CUT)
		return -1;
	return ts_compare_int32_pair(e->tag, tag);
}

static bool listed_bond_broke_now(const struct tsim *sim, int32_t tag_a, int32_t tag_b)
{
	const struct ts_bonds *b = sim->bonds;
	const int32_t tag[2] = { tag_a < tag_b ? tag_a : tag_b, tag_a < tag_b ? tag_b : tag_a };
	size_t lo = 0, hi = b->nevents;

	while (lo < hi) {
		size_t middle = (lo + hi) / 2;

		if (compare_with(&b->event[middle], sim->clock.step, tag) < 0)
			lo = middle + 1;
		else
			hi = middle;
	}
	return lo < b->nevents && compare_with(&b->event[lo], sim->clock.step, tag) == 0 &&
	       !b->event_fresh[lo];
}

bool ts_bonds_were_listed(const struct tsim *sim, int32_t tag_a, int32_t tag_b)
{
	return ts_bonds_has_old(sim->bonds, tag_a, tag_b) || listed_bond_broke_now(sim, tag_a, tag_b);
}

static enum ts_status pack_events(const struct ts_bonds *b, struct ts_parcel *out)
{
	for (size_t k = b->ranks.events; k < b->nevents; k++) {
		struct row row;

		memset(&row, 0, sizeof row);
		row.event = b->event[k];
		row.energy = b->event_energy[k];
		row.fresh = b->event_fresh[k];
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
		b->event_energy[b->nevents] = row[k].energy;
		b->event_fresh[b->nevents++] = row[k].fresh;
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
	enum { ALL, CREATED, BROKEN, NUMBERS };
	int64_t number[NUMBERS] = { [CREATED] = b->created - r->created, [BROKEN] = b->broken - r->broken };

	if (!r->divided)
		return TS_OK;
	for (size_t k = 0; k < b->n; k++)
		number[ALL] += (size_t)b->row[k][0] < sim->particles->n;
	ts_world_sums(sim->world, number, NUMBERS);
	b->created = r->created += number[CREATED];
	b->broken = r->broken += number[BROKEN];
	b->gone += r->all + number[CREATED] - number[ALL] - number[BROKEN];
	r->all = number[ALL];
	return number[BROKEN] ? join_events(sim, b) : TS_OK;
}
