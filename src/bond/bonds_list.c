/* The list of bonds: adding, sorting, deleting. */
#include <assert.h>
#include <string.h>

#include "base/sort.h"
#include "bond/bonds.h"

#include "base/banned.h"

static enum ts_status reserve_bonds(struct ts_bonds *b, size_t n)
{
	size_t start = b->capacity, capacity = start;

#define GROW_COLUMN(column)                              \
	do {                                             \
		capacity = start;                        \
		TS_TRY(TS_GROW(b->column, capacity, n)); \
	} while (0)
	GROW_COLUMN(tag);
	GROW_COLUMN(type);
	GROW_COLUMN(rest);
	GROW_COLUMN(own);
	GROW_COLUMN(row);
	GROW_COLUMN(tension);
	GROW_COLUMN(breaks);
	GROW_COLUMN(fresh);
#undef GROW_COLUMN
	b->capacity = capacity;
	if (b->softens) {
		TS_TRY(TS_GROW(b->damage, b->damage_capacity, n));
		TS_TRY(TS_GROW(b->lost, b->lost_capacity, n));
	}
	if (!b->transmits)
		return TS_OK;
	TS_TRY(TS_GROW(b->reference, b->reference_capacity, n));
	return TS_GROW(b->load, b->load_capacity, n);
}

enum ts_status ts_bonds_transmit(struct tsim *sim, bool moments)
{
	struct ts_bonds *b = sim->bonds;

	if (b->transmits == moments)
		return TS_OK;
	b->transmits = moments;
	if (moments) {
		if (reserve_bonds(b, b->n + 1) != TS_OK)
			return ts_nomem(&sim->error);
		memset(b->reference, 0, b->n * sizeof *b->reference);
		memset(b->load, 0, b->n * sizeof *b->load);
		return TS_OK;
	}
	ts_free(b->reference);
	ts_free(b->load);
	b->reference = NULL;
	b->load = NULL;
	b->reference_capacity = b->load_capacity = 0;
	return TS_OK;
}

enum ts_status ts_bonds_soften(struct tsim *sim, bool softens)
{
	struct ts_bonds *b = sim->bonds;

	if (b->softens == softens)
		return TS_OK;
	b->softens = softens;
	if (softens) {
		if (reserve_bonds(b, b->n + 1) != TS_OK)
			return ts_nomem(&sim->error);
		memset(b->damage, 0, b->n * sizeof *b->damage);
		return TS_OK;
	}
	ts_free(b->damage);
	ts_free(b->lost);
	b->damage = NULL;
	b->lost = NULL;
	b->damage_capacity = b->lost_capacity = 0;
	return TS_OK;
}

/* Of a bond of this type: what its coefficients give, otherwise `rest`. */
static double length_without_force(const struct tsim *sim, int type, double rest)
{
	const struct ts_instance *style = ts_sim_only(sim, TS_KIND_BOND);
	const struct ts_coeffs *coeffs = style ? &((const struct ts_bond *)style->state)->coeffs : NULL;

	if (!style || !ts_bond_style_of(style)->length || type >= (int)coeffs->n || !coeffs->given[type])
		return rest;
	return ts_bond_style_of(style)->length(ts_coeff(coeffs, (size_t)type));
}

void ts_bonds_set_lengths(struct tsim *sim)
{
	const struct ts_instance *style = ts_sim_only(sim, TS_KIND_BOND);
	struct ts_bonds *b = sim->bonds;

	for (size_t k = 0; style && k < b->n; k++)
		b->rest[k] = length_without_force(sim, b->type[k], b->own[k]);
}

enum ts_status ts_bonds_add(struct tsim *sim, int32_t tag_a, int32_t tag_b, int type, double rest)
{
	struct ts_bonds *b = sim->bonds;

	if (reserve_bonds(b, b->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	b->tag[b->n][0] = tag_a < tag_b ? tag_a : tag_b;
	b->tag[b->n][1] = tag_a < tag_b ? tag_b : tag_a;
	b->type[b->n] = type;
	b->own[b->n] = rest;
	b->rest[b->n] = length_without_force(sim, type, rest);
	b->tension[b->n] = 0;
	b->fresh[b->n] = 1;
	if (b->transmits) {
		b->reference[b->n] = (struct ts_bond_reference){ 0 };
		b->load[b->n] = (struct ts_bond_load){ 0 };
	}
	if (b->softens)
		b->damage[b->n] = (struct ts_bond_damage){ 0 };
	b->n++;
	b->created++;
	return TS_OK;
}

enum ts_status ts_bonds_reserve(struct tsim *sim, size_t n)
{
	return reserve_bonds(sim->bonds, n) == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_bonds_reserve_events(struct tsim *sim, size_t n)
{
	struct ts_bonds *b = sim->bonds;

	return TS_GROW(b->event, b->event_capacity, n) == TS_OK &&
			       TS_GROW(b->event_energy, b->energy_capacity, n) == TS_OK &&
			       TS_GROW(b->event_fresh, b->event_fresh_capacity, n) == TS_OK
		       ? TS_OK
		       : ts_nomem(&sim->error);
}

/* ---- order and removal */

size_t ts_bond_columns(const struct ts_bonds *b, struct ts_bond_column column[TS_BOND_COLUMNS])
{
	const struct {
		void *data;
		size_t size;
		bool there;
	} all[] = {
		{ b->tag, sizeof *b->tag, true },
		{ b->type, sizeof *b->type, true },
		{ b->rest, sizeof *b->rest, true },
		{ b->own, sizeof *b->own, true },
		{ b->tension, sizeof *b->tension, true },
		{ b->fresh, sizeof *b->fresh, true },
		{ b->reference, sizeof *b->reference, b->transmits },
		{ b->load, sizeof *b->load, b->transmits },
		{ b->damage, sizeof *b->damage, b->softens },
	};
	size_t n = 0;

	static_assert(sizeof all / sizeof *all == TS_BOND_COLUMNS, "room for all columns");
	for (size_t k = 0; k < TS_BOND_COLUMNS; k++)
		if (all[k].there)
			column[n++] = (struct ts_bond_column){ all[k].data, all[k].size };
	return n;
}

/* The bond that comes next. */
struct place {
	int32_t tag[2];
	uint32_t from;
};

static int compare_places(const void *a, const void *b)
{
	const struct place *p = a, *q = b;
	int c = ts_compare_int32_pair(p->tag, q->tag);

	return c ? c : (p->from > q->from) - (p->from < q->from);
}

/* Bond k becomes bond order[k].from. */
static enum ts_status reorder(struct ts_bonds *b, const struct place *order)
{
	struct ts_bond_column column[TS_BOND_COLUMNS];
	size_t n = ts_bond_columns(b, column), widest = 0;
	char *room;

	for (size_t c = 0; c < n; c++)
		widest = column[c].size > widest ? column[c].size : widest;
	room = ts_alloc(b->n, widest);
	if (!room)
		return TS_NOMEM;
	for (size_t c = 0; c < n; c++) {
		const size_t size = column[c].size;

		for (size_t k = 0; k < b->n; k++)
			memcpy(room + k * size, (char *)column[c].data + order[k].from * size, size);
		memcpy(column[c].data, room, b->n * size);
	}
	ts_free(room);
	return TS_OK;
}

static bool is_sorted(const struct ts_bonds *b)
{
	for (size_t k = 1; k < b->n; k++)
		if (ts_compare_int32_pair(b->tag[k - 1], b->tag[k]) > 0)
			return false;
	return true;
}

void ts_bonds_sort(struct ts_bonds *b)
{
	struct place *order;

	if (is_sorted(b))
		return;
	order = ts_alloc(b->n, sizeof *order);
	for (size_t k = 0; order && k < b->n; k++)
		order[k] = (struct place){ { b->tag[k][0], b->tag[k][1] }, (uint32_t)k };
	if (order) { /* the order only matters for the speed of look-up and for reproducible lists */
		ts_sort(order, b->n, sizeof *order, compare_places);
		(void)reorder(b, order);
	}
	ts_free(order);
}

/* The bond of two particles; n: there is none. */
static size_t find_bond(const struct ts_bonds *b, int32_t tag_a, int32_t tag_b)
{
	int32_t wanted[2] = { tag_a < tag_b ? tag_a : tag_b, tag_a < tag_b ? tag_b : tag_a };
	size_t lo = 0, hi = b->n;

	while (lo < hi) {
		size_t mid = (lo + hi) / 2;
		int c = ts_compare_int32_pair(b->tag[mid], wanted);

		if (c == 0)
			return mid;
		if (c < 0)
			lo = mid + 1;
		else
			hi = mid;
	}
	return b->n;
}

bool ts_bonds_has(const struct ts_bonds *b, int32_t tag_a, int32_t tag_b)
{
	return find_bond(b, tag_a, tag_b) < b->n;
}

bool ts_bonds_has_old(const struct ts_bonds *b, int32_t tag_a, int32_t tag_b)
{
	size_t k = find_bond(b, tag_a, tag_b);

	return k < b->n && !b->fresh[k];
}

void ts_bonds_delete(struct ts_bonds *b, const unsigned char *flag)
{
	struct ts_bond_column column[TS_BOND_COLUMNS];
	size_t n = ts_bond_columns(b, column), kept = 0;

	while (kept < b->n && !flag[kept])
		kept++;
	for (size_t k = kept; k < b->n; k++) {
		if (flag[k])
			continue;
		for (size_t c = 0; c < n; c++)
			memcpy((char *)column[c].data + kept * column[c].size,
			       (const char *)column[c].data + k * column[c].size, column[c].size);
		memcpy(b->row[kept++], b->row[k], sizeof b->row[k]);
	}
	b->n = kept;
}
