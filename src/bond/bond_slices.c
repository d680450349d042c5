#include "bond/bond_slices.h"

#include "base/parallel.h"
#include "base/sort.h"
#include "bond/bonds.h"
#include "particle/particles.h"

#include "base/banned.h"

/* Particles are sorted by number of bonds within windows of this size, so that neighbours in memory
 * stay close. */
enum { WINDOW = 128 };

static size_t bond_count(const struct ts_bonds *b, size_t i)
{
	return b->gather.first[i + 1] - b->gather.first[i];
}

struct slicing {
	struct ts_bonds *bonds;
	size_t n;	/* particles */
	int32_t *order; /* indices of particles, by window */
};

/* Sorts the windows from .. to-1: descending number of bonds, then ascending index. */
static void order_windows(void *context, size_t from, size_t to)
{
	const struct slicing *t = context;
	uint64_t key[WINDOW], spare[WINDOW];

	for (size_t w = from; w < to; w++) {
		size_t begin = w * WINDOW, n = t->n - begin < WINDOW ? t->n - begin : WINDOW;

		for (size_t k = 0; k < n; k++)
			key[k] = (UINT32_MAX - (uint64_t)bond_count(t->bonds, begin + k)) << 32 | (begin + k);
		ts_sort_keys(key, spare, n);
		for (size_t k = 0; k < n; k++)
			t->order[begin + k] = (int32_t)(uint32_t)key[k];
	}
}

/* Cuts the particles begin .. end-1 of the order into slices; returns the next free row. */
static size_t cut_window(const struct slicing *t, size_t begin, size_t end, size_t row)
{
	struct ts_bond_slices *s = &t->bonds->slices;

	while (end > begin && !bond_count(t->bonds, (size_t)t->order[end - 1]))
		end--;
	for (; begin < end; begin += TS_BOND_LANES) {
		struct ts_bond_slice *slice = &s->slice[s->n++];

		slice->first = row;
		slice->depth = (uint32_t)bond_count(t->bonds, (size_t)t->order[begin]);
		slice->n = (uint32_t)(end - begin < TS_BOND_LANES ? end - begin : TS_BOND_LANES);
		for (size_t k = 0; k < TS_BOND_LANES; k++)
			slice->particle[k] = t->order[k < slice->n ? begin + k : end - 1];
		row += slice->depth;
	}
	return row;
}

static void fill_lane(const struct ts_bonds *b, struct ts_bond_slice *slice, size_t lane)
{
	const struct ts_bond_slices *s = &b->slices;
	int32_t i = slice->particle[lane];
	size_t n = lane < slice->n ? bond_count(b, (size_t)i) : 0;
	const uint32_t *entry = b->gather.entry + b->gather.first[i];

	for (size_t k = 0; k < slice->depth; k++) {
		size_t row = slice->first + k;

		s->partner[row][lane] = k < n ? b->row[entry[k] >> 1][!(entry[k] & 1)] : i;
		s->rest[row][lane] = k < n ? b->rest[entry[k] >> 1] : 0;
		s->bond[row][lane] = k < n ? entry[k] : TS_BOND_NONE;
		if (k < n && slice->type != b->type[entry[k] >> 1])
			slice->type = 0;
	}
}

static void fill_slices(void *context, size_t from, size_t to)
{
	const struct slicing *t = context;
	const struct ts_bonds *b = t->bonds;

	for (size_t k = from; k < to; k++) {
		struct ts_bond_slice *slice = &b->slices.slice[k];

		slice->type = b->type[b->gather.entry[b->gather.first[slice->particle[0]]] >> 1];
		for (size_t lane = 0; lane < TS_BOND_LANES; lane++)
			fill_lane(b, slice, lane);
	}
}

/* Returns the number of rows. */
static size_t cut_slices(const struct slicing *t)
{
	size_t rows = 0;

	t->bonds->slices.n = 0;
	for (size_t begin = 0; begin < t->n; begin += WINDOW)
		rows = cut_window(t, begin, t->n - begin < WINDOW ? t->n : begin + WINDOW, rows);
	return rows;
}

enum ts_status ts_bond_slices_build(const struct tsim *sim, struct ts_bonds *bonds)
{
	size_t n = sim->particles->n, windows = (n + WINDOW - 1) / WINDOW, rows;
	struct ts_bond_slices *s = &bonds->slices;
	struct slicing t = { bonds, n, ts_alloc(n, sizeof *t.order) };

	if (!t.order || TS_RENEW(s->slice, s->capacity, windows * (WINDOW / TS_BOND_LANES)) != TS_OK) {
		ts_free(t.order);
		return TS_NOMEM;
	}
	ts_parallel(ts_team(sim, n), windows, order_windows, &t);
	rows = cut_slices(&t);
	ts_free(t.order);
	TS_TRY(TS_RENEW(s->partner, s->partner_capacity, rows));
	TS_TRY(TS_RENEW(s->rest, s->rest_capacity, rows));
	TS_TRY(TS_RENEW(s->bond, s->bond_capacity, rows));
	ts_parallel(ts_team(sim, n), s->n, fill_slices, &t);
	s->rows = rows;
	return TS_OK;
}

void ts_bond_slices_release(struct ts_bond_slices *s)
{
	ts_free(s->slice);
	ts_free(s->partner);
	ts_free(s->rest);
	ts_free(s->bond);
	*s = (struct ts_bond_slices){ 0 };
}
