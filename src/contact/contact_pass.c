#include "contact/contact_pass.h"

#include <string.h>

#include "neigh/force_slots.h"
#include "neigh/neigh.h"
#include "neigh/touching_sums.h"

#include "base/banned.h"

struct pass_task {
	const struct ts_contact_list *list;
	const struct ts_contacts_pass *pass[2]; /* forces, fused pass or NULL */
};

static void sum_chunk(const struct pass_task *w, size_t c)
{
	const struct ts_contact_list *list = w->list;
	size_t from = c * TS_CONTACT_CHUNK, n = list->particles,
	       to = n - from < TS_CONTACT_CHUNK ? n : from + TS_CONTACT_CHUNK;

	ts_touching_sums_update(list, from, to);
	for (int k = 0; k < 2; k++)
		if (w->pass[k] && (w->pass[k]->sum_all || list->chunk[c].end > 0))
			w->pass[k]->sum(w->pass[k]->context, from, to);
	list->chunk_summed[c] = 1;
}

/* Computes TS_BLOCKS_PER_SUM blocks, then sums the particles all of whose pairs are done while the forces are
 * still in the cache. Chunks whose pairs are in shares of several threads are summed at the end. */
static void compute_share(const struct pass_task *w, size_t share)
{
	const struct ts_contact_list *list = w->list;
	const struct ts_contact_span *span = &list->span[share];
	size_t c = 0, done;

	for (size_t b = span->block; b < span->block_end; b += TS_BLOCKS_PER_SUM) {
		size_t end =
			span->block_end - b < TS_BLOCKS_PER_SUM ? span->block_end : b + TS_BLOCKS_PER_SUM;
		const struct ts_active_block *last = &list->block[end - 1];

		for (int k = 0; k < 2 && w->pass[k]; k++)
			w->pass[k]->compute(w->pass[k]->context, b, end);
		while ((done = ts_contact_chunk_done(list, span->active, (size_t)last->first + last->n, &c)) <
		       list->chunks)
			sum_chunk(w, done);
	}
}

static void compute_shares(void *context, size_t from, size_t to)
{
	for (size_t k = from; k < to; k++)
		compute_share(context, k);
}

static void sum_remaining_share(void *context, size_t from, size_t to)
{
	const struct pass_task *w = context;

	for (size_t c = from; c < to; c++)
		if (!w->list->chunk_summed[c])
			sum_chunk(w, c);
}

enum ts_status ts_contacts_compute(struct tsim *sim, const struct ts_contacts_pass *forces)
{
	struct ts_fused_pass *fused = sim->neigh->fused_pass;
	const struct ts_contact_list *list = &sim->neigh->contacts;
	struct pass_task w = { list, { forces, fused && list->n ? &fused->pass : NULL } };

	if (w.pass[1]) {
		fused->begun = true;
		TS_TRY(fused->start(sim, fused->pass.context));
	}
	if (list->chunks)
		memset(list->chunk_summed, 0, list->chunks);
	ts_parallel(list->shares, (size_t)list->shares, compute_shares, &w);
	ts_parallel(ts_team(sim, 4 * list->n), list->chunks, sum_remaining_share, &w);
	return TS_OK;
}

void ts_contacts_fuse(struct tsim *sim, struct ts_fused_pass *fused)
{
	fused->begun = false;
	sim->neigh->fused_pass = fused;
}
