/* What the ledger knows of particles and bonds that go to other ranks, or are not there any more. */
#include <string.h>

#include "base/sort.h"
#include "bond/bonds.h"
#include "energy/ledger.h"
#include "particle/division.h"
#include "particle/identity.h"
#include "particle/particles.h"

#include "base/banned.h"

/* ---- particles that are deleted */

static enum ts_status note_particles(struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_particles *p = sim->particles;

	if (TS_GROW(l->seen, l->seen_capacity, p->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	l->nseen = p->n;
	for (size_t i = 0; i < p->n; i++) {
		l->seen[i][0] = p->tag[i];
		l->seen[i][1] = p->body ? p->body[i] : 0;
	}
	ts_sort(l->seen, l->nseen, sizeof *l->seen, ts_compare_int32);
	return TS_OK;
}

enum ts_status ts_ledger_before_exchange(struct tsim *sim, struct ts_ledger *l)
{
	l->all = ts_division_sum(sim, (int64_t)sim->particles->n);
	l->ngone = 0;
	return note_particles(sim, l);
}

/* Identity, body, and 1 for a particle that has left this rank, -1 for one that has come. */
enum { TAG, BODY, LEFT, MOVE };

/* Appends the particles that are in the first list and not in the second one. */
static enum ts_status pack_others(int32_t (*in)[2], size_t n, int32_t (*not_in)[2], size_t others,
				  int32_t left, struct ts_parcel *out)
{
	for (size_t k = 0, o = 0; k < n; k++) {
		const int32_t row[MOVE] = { in[k][0], in[k][1], left };

		while (o < others && not_in[o][0] < in[k][0])
			o++;
		if (o < others && not_in[o][0] == in[k][0])
			continue;
		TS_TRY(ts_parcel_add(out, row, sizeof row));
	}
	return TS_OK;
}

/* Particles that left a rank and came to none. */
static enum ts_status append_gone(struct ts_ledger *l, const struct ts_parcel *all)
{
	int32_t(*row)[MOVE] = (int32_t(*)[MOVE])(void *)all->data;
	size_t n = all->n / sizeof *row;

	TS_TRY(TS_GROW(l->gone, l->gone_capacity, l->ngone + n + 1));
	ts_sort(row, n, sizeof *row, ts_compare_int32);
	for (size_t k = 0; k < n;) {
		size_t first = k;
		int32_t left = 0;

		for (; k < n && row[k][TAG] == row[first][TAG]; k++)
			left += row[k][LEFT];
		if (left > 0)
			memcpy(l->gone[l->ngone++], row[first], sizeof *l->gone);
	}
	ts_sort(l->gone, l->ngone, sizeof *l->gone, ts_compare_int32);
	return TS_OK;
}

/* Bodies without members are not counted any more. */
static void drop_bodies(struct ts_ledger *l)
{
	size_t kept = 0;

	for (size_t b = 0; b < l->ncounted; b++) {
		int32_t left = l->counted[b].members;

		for (size_t k = 0; k < l->ngone; k++)
			left -= l->gone[k][1] == l->counted[b].id;
		if (left > 0)
			l->counted[kept++] = l->counted[b];
	}
	l->ncounted = kept;
}

static enum ts_status share_moves(struct tsim *sim, struct ts_ledger *l, int32_t (*before)[2], size_t n)
{
	struct ts_parcel mine = { 0 }, all = { 0 };
	enum ts_status status = pack_others(before, n, l->seen, l->nseen, 1, &mine);

	if (status == TS_OK)
		status = pack_others(l->seen, l->nseen, before, n, -1, &mine);
	if (status == TS_OK)
		status = ts_world_share(sim->world, &mine, &all);
	if (status == TS_OK)
		status = append_gone(l, &all);
	ts_parcel_release(&mine);
	ts_parcel_release(&all);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_ledger_find_deleted(struct tsim *sim, struct ts_ledger *l, bool *any)
{
	int64_t all = ts_division_sum(sim, (int64_t)sim->particles->n);
	size_t n = l->nseen;
	int32_t(*before)[2];
	enum ts_status status;

	*any = all < l->all;
	l->all = all;
	if (!*any)
		return TS_OK;
	before = ts_alloc(n, sizeof *before);
	if (!before)
		return ts_nomem(&sim->error);
	if (n)
		memcpy(before, l->seen, n * sizeof *before);
	status = note_particles(sim, l);
	if (status == TS_OK)
		status = share_moves(sim, l, before, n);
	if (status == TS_OK)
		drop_bodies(l);
	ts_free(before);
	return status;
}

bool ts_ledger_is_deleted(const struct ts_ledger *l, int32_t tag)
{
	size_t k = ts_find_int32(l->gone, l->ngone, sizeof *l->gone, tag);

	return k < l->ngone && l->gone[k][0] == tag;
}

/* ---- notes of bonds: each is on one rank, or all are on all */

static enum ts_status share_notes(struct tsim *sim, struct ts_ledger *l)
{
	struct ts_parcel mine = { .data = (unsigned char *)l->bond, .n = l->bonds * sizeof *l->bond },
			 all = { 0 };
	enum ts_status status = ts_world_share(sim->world, &mine, &all);

	l->bonds = all.n / sizeof *l->bond;
	if (status == TS_OK)
		status = TS_GROW(l->bond, l->bond_capacity, l->bonds + 1);
	if (status == TS_OK && all.n) {
		memcpy(l->bond, all.data, all.n);
		ts_sort(l->bond, l->bonds, sizeof *l->bond, ts_compare_int32_pair);
	}
	ts_parcel_release(&all);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

static enum ts_status keep_own_notes(struct tsim *sim, struct ts_ledger *l)
{
	struct ts_identities own;
	size_t kept = 0;

	TS_TRY(ts_identities(sim, false, &own));
	for (size_t k = 0; k < l->bonds; k++)
		if (ts_identity_row(&own, l->bond[k].tag[0]) >= 0)
			l->bond[kept++] = l->bond[k];
	l->bonds = kept;
	return TS_OK;
}

enum ts_status ts_ledger_share_bonds(struct tsim *sim, struct ts_ledger *l)
{
	l->relisted = true;
	if (!ts_sim_only(sim, TS_KIND_BOND))
		return TS_OK;
	return sim->division ? keep_own_notes(sim, l) : share_notes(sim, l);
}

/* ---- bonds that are not there any more */

/* A bond that was noted and is not on this rank any more, one that has come, one that has broken in this step. */
enum kind { NOTED, HERE, BROKEN };
struct row {
	int32_t tag[2], kind, order;
	double energy;
};

static enum ts_status add_row(struct ts_ledger *l, const int32_t tag[2], enum kind kind, size_t order,
			      double energy)
{
	const struct row row = { { tag[0], tag[1] }, (int32_t)kind, (int32_t)order, energy };

	return ts_parcel_add(&l->missing, &row, sizeof row);
}

static double total_energy(const struct ts_ledger_note *note)
{
	double sum = note->energy[0];

	for (int mode = 1; mode < TS_BOND_MODES; mode++)
		sum += note->energy[mode];
	return sum;
}

/* Both lists are sorted by identities. */
static enum ts_status pack_differences(const struct tsim *sim, struct ts_ledger *l, bool *any)
{
	const struct ts_bonds *bonds = sim->bonds;
	size_t k = 0, b = 0;

	while (k < l->bonds || b < bonds->n) {
		int order = k == l->bonds   ? 1
			    : b == bonds->n ? -1
					    : ts_compare_int32_pair(l->bond[k].tag, bonds->tag[b]);

		if (order < 0) {
			TS_TRY(add_row(l, l->bond[k].tag, NOTED, 0, total_energy(&l->bond[k])));
			*any = true;
		} else if (order > 0 && (size_t)bonds->row[b][0] < sim->particles->n) {
			TS_TRY(add_row(l, bonds->tag[b], HERE, 0, 0));
		}
		k += order <= 0;
		b += order >= 0;
	}
	return TS_OK;
}

static enum ts_status pack_missing(const struct tsim *sim, struct ts_ledger *l, bool *any)
{
	const struct ts_bonds *bonds = sim->bonds;

	TS_TRY(pack_differences(sim, l, any));
	for (size_t e = bonds->nevents; e-- > bonds->past_events && bonds->event[e].step == sim->clock.step;)
		TS_TRY(add_row(l, bonds->event[e].tag, BROKEN, e, bonds->event_energy[e]));
	return TS_OK;
}

static int compare_rows(const void *a, const void *b)
{
	const struct row *p = a, *q = b;
	int tags = ts_compare_int32_pair(p->tag, q->tag);

	if (tags)
		return tags;
	return p->kind != q->kind ? (p->kind > q->kind) - (p->kind < q->kind)
				  : (p->order > q->order) - (p->order < q->order);
}

/* Elastic energy lost with the bond of rows first .. end-1: ledger_parts.c. */
static double lost_energy(const struct row *first, const struct row *end)
{
	const struct row *last = end - 1;

	if (first->kind != NOTED || (first + 1 < end && first[1].kind == HERE))
		return 0;
	return last->kind == BROKEN ? 0.5 * (first->energy + last->energy) : first->energy;
}

static enum ts_status post_missing(struct tsim *sim, struct ts_ledger *l, const struct ts_ledger_entry *entry,
				   const double *value)
{
	struct ts_parcel all = { 0 };
	struct ts_exactsum sum = ts_exactsum_start();
	enum ts_status status = ts_world_share(sim->world, &l->missing, &all);
	struct row *row = (struct row *)(void *)all.data;
	size_t n = all.n / sizeof *row;

	(void)entry, (void)value;
	ts_sort(row, n, sizeof *row, compare_rows);
	for (size_t k = 0, end = 0; k < n; k = end) {
		while (end < n && ts_compare_int32_pair(row[end].tag, row[k].tag) == 0)
			end++;
		ts_exactsum_add(&sum, lost_energy(row + k, row + end));
	}
	ts_compensated_add(&l->broken, ts_exactsum_value(&sum));
	ts_parcel_release(&all);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_ledger_account_missing(struct tsim *sim, struct ts_ledger *l)
{
	struct ts_ledger_entry entry = { .post = post_missing, .maybe = true };

	if (pack_missing(sim, l, &entry.counts) != TS_OK)
		return ts_nomem(&sim->error);
	return ts_ledger_enter(sim, l, &entry, NULL);
}
