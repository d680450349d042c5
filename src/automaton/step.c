#include "automaton/step.h"

#include "automaton/granule.h"
#include "automaton/lanes.h"
#include "base/alloc.h"
#include "base/clones.h"
#include "base/parallel.h"

#include "base/banned.h"

/* Adds the speed to the phase of each granule; those that reach 1 are to move. For other cells both are 0. */
TS_CLONES static void advance(uint32_t *cell, size_t n)
{
	const uint32_t phase = (uint32_t)TS_CELL_LOW << TS_CELL_PHASE;

#pragma omp simd
	for (size_t c = 0; c < n; c++) {
		const uint32_t w = cell[c], sum = (w >> TS_CELL_PHASE & TS_CELL_LOW) + (w & TS_CELL_SPEED);

		cell[c] = (w & ~phase) | (sum & TS_CELL_LOW) << TS_CELL_PHASE | (sum / TS_CELL_ONE) << 31;
	}
}

struct rows {
	struct ts_automaton_lattice *l;
};

static void advance_rows(void *context, size_t from, size_t to)
{
	struct ts_automaton_lattice *l = ((struct rows *)context)->l;

	advance(l->cell + (from + 1) * l->stride, (to - from) * l->stride);
}

/* Appends the cells from .. to-1 with granules that are to move; there must be room for one entry more. */
static uint32_t list_due(const uint32_t *cell, size_t from, size_t to, uint32_t *mover, uint32_t n)
{
	for (size_t c = from; c < to; c++) {
		mover[n] = (uint32_t)c;
		n += ts_cell_state(cell[c]) == TS_CELL_DUE;
	}
	return n;
}

enum { AHEAD = 32 }; /* entries whose memory is fetched ahead */

/* at[k]: uniform in 0 .. n-k-1 for k < n */
TS_CLONES static void draw_places(struct ts_draws_stream order, uint32_t n, uint32_t at[AHEAD])
{
#pragma omp simd
	for (uint32_t k = 0; k < AHEAD; k++)
		at[k] = ts_draws_below(ts_draws_mix(order.at + (k + 1) * order.increment), n - k);
}

/* Entries that are taken in random order (R. Durstenfeld, Commun. ACM 7 (1964) 420). The places of the next AHEAD are known
 * before they are needed, and their memory is fetched. */
struct urn {
	uint32_t *entry;
	uint32_t left;
	struct ts_draws_stream order;
	uint32_t at[AHEAD];
};

static uint32_t next_take(const struct urn *u)
{
	return u->left < AHEAD ? u->left : AHEAD;
}

static void look_ahead(struct urn *u)
{
	draw_places(u->order, u->left, u->at);
	u->order.at += AHEAD * u->order.increment;
	for (uint32_t k = 0; k < next_take(u); k++)
		__builtin_prefetch(u->entry + u->at[k]);
}

static struct urn urn_of(uint32_t *entry, uint32_t n, struct ts_draws_stream order)
{
	struct urn u = { .entry = entry, .left = n, .order = order };

	look_ahead(&u);
	return u;
}

/* Takes up to AHEAD entries; those at the end of the list are free then. Returns their number, 0 at the end. */
static uint32_t take_some(struct urn *u, uint32_t out[AHEAD])
{
	const uint32_t take = next_take(u);

	for (uint32_t k = 0; k < take; k++) {
		out[k] = u->entry[u->at[k]];
		u->entry[u->at[k]] = u->entry[u->left - k - 1];
	}
	u->left -= take;
	if (u->left > 0)
		look_ahead(u);
	return take;
}

/* The entries in the order in which they are drawn, from the last to the first. */
static void shuffle(uint32_t *entry, uint32_t n, struct ts_draws_stream order)
{
	struct urn u = urn_of(entry, n, order);
	uint32_t drawn[AHEAD], take;

	while ((take = take_some(&u, drawn)) > 0)
		for (uint32_t k = 0; k < take; k++)
			entry[u.left + take - k - 1] = drawn[k];
}

static void fetch_around(const struct ts_automaton_lattice *l, uint32_t c)
{
	__builtin_prefetch(l->cell + c - l->stride);
	__builtin_prefetch(l->cell + c);
	__builtin_prefetch(l->cell + c + l->stride);
}

/* Updates the granules of the n cells, in random order. With each that is updated, the cells around one of the next are
 * fetched: all at a time would wait for each other. */
static void update_all(struct ts_automaton_lattice *l, const struct ts_laws *laws, uint32_t *mover,
		       uint32_t n, struct ts_draws_stream order, struct ts_draws_stream draws,
		       struct ts_automaton_count *count)
{
	struct urn u = urn_of(mover, n, order);
	struct ts_automaton_count here = { 0 };
	uint32_t c[2][AHEAD] = { { 0 } }, due = take_some(&u, c[0]), next;

	for (int turn = 0; due > 0; turn = !turn, due = next) {
		next = take_some(&u, c[!turn]);
		for (uint32_t k = 0; k < due; k++) {
			if (k < next)
				fetch_around(l, c[!turn][k]);
			ts_granule_update(l, laws, c[turn][k], &draws, &here);
		}
	}
	*count = here;
}

static void add_count(struct ts_automaton_count *to, const struct ts_automaton_count *part)
{
	to->due += part->due;
	to->moved += part->moved;
	to->collided += part->collided;
	to->clipped += part->clipped;
}

/* ---- blocks */

enum { WIDTH = 32, HEIGHT = 32 }; /* the largest block: those of all lanes fit into the cache */
enum { MOST = (WIDTH + 1) * HEIGHT + 1 };

struct blocks {
	struct ts_automaton_lattice *l;
	const struct ts_laws *laws;
	uint64_t seed;
	int64_t step;
	int n[2]; /* number along x, even, and y, the first and the last of which may be cut off */
	int first
		[2]; /* the column at which the first block begins; rows of the first one below the lattice */
	int colour[2]; /* parities of the blocks being updated */
};

/* Even, as the lattice is periodic along x: blocks of one group do not touch. */
static int blocks_along(int nx)
{
	return 2 * ((nx + 2 * WIDTH - 1) / (2 * WIDTH));
}

static int most_blocks_across(int ny)
{
	return (ny + HEIGHT - 1) / HEIGHT + 1;
}

static uint32_t list_block(const struct blocks *b, int i, int j, uint32_t *mover)
{
	const struct ts_automaton_lattice *l = b->l;
	const int64_t nx = l->nx;
	int low = j * HEIGHT - b->first[1], high = low + HEIGHT;
	int from = (int)(nx * i / b->n[0]) + b->first[0], to = (int)(nx * (i + 1) / b->n[0]) + b->first[0];
	uint32_t n = 0;

	low = low < 0 ? 0 : low;
	high = high > l->ny ? l->ny : high;
	for (int y = low; y < high; y++) {
		const size_t row = ts_automaton_at(l, 0, y);

		/* the part before the end of the row, and the part after it */
		if (from < l->nx)
			n = list_due(l->cell, row + (size_t)from, row + (size_t)(to < l->nx ? to : l->nx),
				     mover, n);
		if (to > l->nx)
			n = list_due(l->cell, row + (size_t)(from > l->nx ? from - l->nx : 0),
				     row + (size_t)(to - l->nx), mover, n);
	}
	return n;
}

static uint32_t block_number(const struct blocks *b, size_t k, int *i, int *j)
{
	const size_t across = (size_t)b->n[0] / 2;

	*i = 2 * (int)(k % across) + b->colour[0];
	*j = 2 * (int)(k / across) + b->colour[1];
	return (uint32_t)*j * (uint32_t)b->n[0] + (uint32_t)*i;
}

static void update_one_by_one(const struct blocks *b, size_t from, size_t to)
{
	uint32_t mover[MOST];

	for (size_t k = from; k < to; k++) {
		int i, j;
		const uint32_t block = block_number(b, k, &i, &j);

		update_all(b->l, b->laws, mover, list_block(b, i, j, mover),
			   ts_draws_start(b->seed, b->step, block, TS_DRAWS_ORDER),
			   ts_draws_start(b->seed, b->step, block, TS_DRAWS_LAWS), &b->l->count[block]);
	}
}

/* The blocks that lanes take. */
struct supply {
	const struct blocks *b;
	size_t next, to;
};

static bool next_block(void *context, struct ts_lane *lane)
{
	struct supply *s = context;
	const struct blocks *b = s->b;
	uint32_t block;
	int i, j;

	if (s->next == s->to)
		return false;
	block = block_number(b, s->next++, &i, &j);
	lane->left = (int32_t)list_block(b, i, j, lane->mover);
	shuffle(lane->mover, (uint32_t)lane->left, ts_draws_start(b->seed, b->step, block, TS_DRAWS_ORDER));
	lane->draws = ts_draws_start(b->seed, b->step, block, TS_DRAWS_LAWS);
	b->l->count[block] = (struct ts_automaton_count){ 0 };
	return true;
}

static void update_in_lanes(const struct blocks *b, size_t from, size_t to)
{
	uint32_t mover[TS_LANES * MOST];
	struct supply supply = { b, from, to };
	const struct ts_lanes lanes = { mover, MOST, next_block, &supply };
	struct ts_automaton_count count = { 0 };
	int i, j;

	ts_lanes_update(b->l, b->laws, &lanes, &count);
	b->l->count[block_number(b, from, &i, &j)] = count;
}

static void update_blocks(void *context, size_t from, size_t to)
{
	const struct blocks *b = context;

	if (ts_lanes_suit(b->laws) && to - from >= TS_LANES / 2)
		update_in_lanes(b, from, to);
	else
		update_one_by_one(b, from, to);
}

static void step_blocks(struct blocks *b, int threads, struct ts_automaton_count *count)
{
	struct ts_draws_stream draws = ts_draws_start(b->seed, b->step, 0, TS_DRAWS_BLOCKS);
	uint32_t colours[4] = { 0, 1, 2, 3 };

	b->n[0] = blocks_along(b->l->nx);
	b->first[0] = (int)ts_draws_below(ts_draws_next(&draws), (uint32_t)b->l->nx);
	b->first[1] = (int)ts_draws_below(ts_draws_next(&draws), HEIGHT);
	b->n[1] = (b->l->ny + b->first[1] + HEIGHT - 1) / HEIGHT;
	shuffle(colours, 4, draws);
	for (int k = 3; k >= 0; k--) {
		b->colour[0] = (int)(colours[k] & 1);
		b->colour[1] = (int)(colours[k] >> 1);
		ts_parallel(threads, (size_t)(b->n[0] / 2) * (size_t)((b->n[1] + 1 - b->colour[1]) / 2),
			    update_blocks, b);
	}
	for (int k = 0; k < b->n[0] * b->n[1]; k++)
		add_count(count, &b->l->count[k]);
}

/* ---- the whole lattice */

bool ts_automaton_step_make(struct ts_automaton_lattice *l, enum ts_automaton_order order)
{
	ts_free(l->count);
	ts_free(l->mover);
	l->count = NULL;
	l->mover = NULL;
	if (order == TS_AUTOMATON_BLOCKS) {
		l->ncounts = (size_t)blocks_along(l->nx) * (size_t)most_blocks_across(l->ny);
		l->count = ts_alloc(l->ncounts, sizeof *l->count);
		return l->count;
	}
	l->mover = ts_alloc_aligned((size_t)l->granules + 1, sizeof *l->mover);
	return l->mover;
}

void ts_automaton_step(struct ts_automaton_lattice *l, const struct ts_laws *laws,
		       enum ts_automaton_order order, uint64_t seed, int64_t step, int threads,
		       struct ts_automaton_count *count)
{
	struct rows rows = { l };

	ts_parallel(threads, (size_t)l->ny, advance_rows, &rows);
	if (order == TS_AUTOMATON_BLOCKS) {
		struct blocks b = { .l = l, .laws = laws, .seed = seed, .step = step };

		step_blocks(&b, threads, count);
	} else {
		struct ts_automaton_count part;
		const uint32_t n = list_due(l->cell, ts_automaton_at(l, 0, 0), ts_automaton_at(l, 0, l->ny),
					    l->mover, 0);

		update_all(l, laws, l->mover, n, ts_draws_start(seed, step, 0, TS_DRAWS_ORDER),
			   ts_draws_start(seed, step, 0, TS_DRAWS_LAWS), &part);
		add_count(count, &part);
	}
}

void ts_automaton_shuffle(uint32_t *entry, uint32_t n, uint64_t seed, int64_t step)
{
	shuffle(entry, n, ts_draws_start(seed, step, 0, TS_DRAWS_ORDER));
}
