#include "contact/contact_pass.h"

#include <string.h>

#include "neigh/force_slots.h"
#include "neigh/neigh.h"

#include "base/banned.h"

struct walking {
	const struct ts_contact_list *rows;
	const struct ts_contacts_pass *walk[2]; /* the second one: NULL, or who follows */
};

static void sum_chunk(const struct walking *w, size_t c)
{
	const struct ts_contact_list *rows = w->rows;
	size_t from = c * TS_CONTACT_CHUNK, n = rows->particles,
	       to = n - from < TS_CONTACT_CHUNK ? n : from + TS_CONTACT_CHUNK;

	for (int k = 0; k < 2; k++)
		if (w->walk[k] && (w->walk[k]->all || rows->chunk[c].end > 0))
			w->walk[k]->sums(w->walk[k]->context, from, to);
	rows->gathered[c] = 1;
}

/* Rows are computed some at a time, and particles whose rows are all done are gathered while these are
 * still near in the caches. Chunks whose rows lie in the shares of several threads wait for the end. */
static void walk_share(const struct walking *w, size_t share)
{
	const struct ts_contact_list *rows = w->rows;
	const struct ts_contact_span *span = &rows->span[share];
	size_t c = 0, done;

	for (size_t b = span->block; b < span->block_end; b += TS_BLOCKS_A_TURN) {
		size_t end = span->block_end - b < TS_BLOCKS_A_TURN ? span->block_end : b + TS_BLOCKS_A_TURN;
		const struct ts_active_block *last = &rows->block[end - 1];

		for (int k = 0; k < 2 && w->walk[k]; k++)
			w->walk[k]->rows(w->walk[k]->context, b, end);
		while ((done = ts_contact_chunk_done(rows, span->near, (size_t)last->first + last->n, &c)) <
		       rows->chunks)
			sum_chunk(w, done);
	}
}

static void walk_shares(void *context, size_t from, size_t to)
{
	for (size_t k = from; k < to; k++)
		walk_share(context, k);
}

static void rest_share(void *context, size_t from, size_t to)
{
	const struct walking *w = context;

	for (size_t c = from; c < to; c++)
		if (!w->rows->gathered[c])
			sum_chunk(w, c);
}

enum ts_status ts_contacts_compute(struct tsim *sim, const struct ts_contacts_pass *forces)
{
	struct ts_fused_pass *follower = sim->neigh->fused_pass;
	const struct ts_contact_list *rows = &sim->neigh->rows;
	struct walking w = { rows, { forces, follower && rows->n ? &follower->walk : NULL } };

	if (w.walk[1]) {
		follower->begun = true;
		TS_TRY(follower->start(sim, follower->walk.context));
	}
	if (rows->chunks)
		memset(rows->gathered, 0, rows->chunks);
	ts_parallel(rows->shares, (size_t)rows->shares, walk_shares, &w);
	ts_parallel(ts_team(sim, rows->n), rows->chunks, rest_share, &w);
	return TS_OK;
}

void ts_contacts_fuse(struct tsim *sim, struct ts_fused_pass *follower)
{
	follower->begun = false;
	sim->neigh->fused_pass = follower;
}
