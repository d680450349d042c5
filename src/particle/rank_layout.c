#include "particle/rank_layout.h"

#include "base/sort.h"
#include "particle/division.h"

#include "base/banned.h"

/* Copies of the particles seen so far. */
struct tally {
	struct ts_rank_layout *layout;
	int owner;     /* of the present particle */
	int64_t *pair; /* of ranks: owner times ranks plus the rank of the copy */
	size_t n, capacity;
	size_t before; /* the pairs before those of the present particle */
	enum ts_status status;
};

static void count_copy(void *context, int rank)
{
	struct tally *t = context;
	const int64_t pair = (int64_t)t->owner * t->layout->ranks + rank;

	if (rank == t->owner)
		return;
	for (size_t k = t->before; k < t->n; k++)
		if (t->pair[k] == pair)
			return;
	t->layout->part[t->owner].sent++;
	t->layout->part[rank].copies++;
	if (TS_GROW(t->pair, t->capacity, t->n + 1) != TS_OK)
		t->status = TS_NOMEM;
	else
		t->pair[t->n++] = pair;
}

static void count_partners(struct tally *t)
{
	ts_sort(t->pair, t->n, sizeof *t->pair, ts_compare_int64);
	for (size_t k = 0; k < t->n; k++)
		if (!k || t->pair[k] != t->pair[k - 1])
			t->layout->part[t->pair[k] / t->layout->ranks].partners++;
}

static enum ts_status count(const struct tsim *sim, double cutoff, struct ts_rank_layout *layout)
{
	const struct ts_rank_blocks *blocks = &layout->blocks;
	const struct ts_particles *p = sim->particles;
	struct tally t = { .layout = layout };

	for (size_t i = 0; i < p->n && t.status == TS_OK; i++) {
		int owner = ts_rank_blocks_owner(blocks, p->xhold[i]);
		struct ts_rank_block own = ts_rank_blocks_block(blocks, owner);

		t.owner = layout->owner[i] = owner;
		layout->part[owner].particles++;
		t.before = t.n;
		ts_copies_visit(sim->domain, blocks, &own, p->xhold[i], cutoff, count_copy, &t);
	}
	count_partners(&t);
	ts_free(t.pair);
	return t.status;
}

enum ts_status ts_rank_layout_make(struct tsim *sim, int ranks, double cutoff, struct ts_rank_layout *layout)
{
	enum ts_status status;

	*layout = (struct ts_rank_layout){ .ranks = ranks };
	layout->part = ts_alloc((size_t)ranks, sizeof *layout->part);
	layout->owner = ts_alloc(sim->particles->n, sizeof *layout->owner);
	status = layout->part && layout->owner ? ts_division_plan(sim, ranks, &layout->blocks)
					       : ts_nomem(&sim->error);
	if (status == TS_OK && count(sim, cutoff, layout) != TS_OK)
		status = ts_nomem(&sim->error);
	return status;
}

void ts_rank_layout_release(struct ts_rank_layout *layout)
{
	ts_rank_blocks_release(&layout->blocks);
	ts_free(layout->part);
	ts_free(layout->owner);
	*layout = (struct ts_rank_layout){ 0 };
}
