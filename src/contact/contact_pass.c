#include "contact/contact_pass.h"

#include <string.h>

#include "neigh/force_slots.h"
#include "neigh/neigh.h"

#include "base/banned.h"

struct walking {
	const struct ts_contact_list *list;
	const struct ts_contacts_pass *walk[2]; /* the second one: NULL, or who follows */
};

static void sum_chunk(const struct walking *w, size_t c)
{
	const struct ts_contact_list *list = w->list;
	size_t from = c * TS_CONTACT_CHUNK, n = list->particles,
	       to = n - from < TS_CONTACT_CHUNK ? n : from + TS_CONTACT_CHUNK;

	for (int k = 0; k < 2; k++)
		if (w->walk[k] && (w->walk[k]->sum_all || list->chunk[c].end > 0))
			w->walk[k]->sum(w->walk[k]->context, from, to);
	list->chunk_summed[c] = 1;
}

/* Rows are computed some at a time, and particles whose rows are all done are gathered while these are
 * still near in the caches. Chunks whose rows lie in the shares of several threads wait for the end. */
static void walk_share(const struct walking *w, size_t share)
{
	const struct ts_contact_list *list = w->list;
	const struct ts_contact_span *span = &list->span[share];
	size_t c = 0, done;

	for (size_t b = span->block; b < span->block_end; b += TS_BLOCKS_PER_SUM) {
		size_t end =
			span->block_end - b < TS_BLOCKS_PER_SUM ? span->block_end : b + TS_BLOCKS_PER_SUM;
		const struct ts_active_block *last = &list->block[end - 1];

		for (int k = 0; k < 2 && w->walk[k]; k++)
			w->walk[k]->compute(w->walk[k]->context, b, end);
		while ((done = ts_contact_chunk_done(list, span->active, (size_t)last->first + last->n, &c)) <
		       list->chunks)
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
		if (!w->list->chunk_summed[c])
			sum_chunk(w, c);
}

enum ts_status ts_contacts_compute(struct tsim *sim, const struct ts_contacts_pass *forces)
{
	struct ts_fused_pass *follower = sim->neigh->fused_pass;
	const struct ts_contact_list *list = &sim->neigh->contacts;
	struct walking w = { list, { forces, follower && list->n ? &follower->walk : NULL } };

	if (w.walk[1]) {
		follower->begun = true;
		TS_TRY(follower->start(sim, follower->walk.context));
	}
	if (list->chunks)
		memset(list->chunk_summed, 0, list->chunks);
	ts_parallel(list->shares, (size_t)list->shares, walk_shares, &w);
	ts_parallel(ts_team(sim, list->n), list->chunks, rest_share, &w);
	return TS_OK;
}

void ts_contacts_fuse(struct tsim *sim, struct ts_fused_pass *follower)
{
	follower->begun = false;
	sim->neigh->fused_pass = follower;
}
