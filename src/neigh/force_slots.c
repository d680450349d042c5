#include "neigh/force_slots.h"

#include <string.h>

#include "base/parallel.h"
#include "neigh/active_pairs.h"
#include "neigh/contact_memory.h"
#include "neigh/touching_sums.h"
#include "particle/particles.h"

#include "base/banned.h"

static size_t particles_end(const struct ts_contact_list *list, size_t c)
{
	return c + 1 < list->chunks ? (c + 1) * TS_CONTACT_CHUNK : list->particles;
}

/* ---- which active pairs each chunk of particles has */

static bool is_divided(const struct ts_contact_list *list, const struct ts_contact_chunk *c)
{
	for (int k = 0; k < list->shares; k++)
		if (list->span[k].active <= c->first && c->end <= list->span[k].active_end)
			return false;
	return true;
}

static struct ts_contact_chunk chunk_of_particles(const struct ts_contact_list *list, size_t from, size_t to)
{
	const struct ts_gather *g = &list->gather;
	struct ts_contact_chunk c = { .first = SIZE_MAX };

	for (size_t k = g->first[from]; k < g->first[to]; k++) {
		uint32_t at = ts_contact_slot(list, g->entry[k] >> 1);

		if (at == TS_PAIR_INACTIVE)
			continue;
		c.first = at < c.first ? at : c.first;
		c.end = at >= c.end ? at + 1 : c.end;
	}
	if (!c.end)
		return (struct ts_contact_chunk){ 0 };
	c.divided = is_divided(list, &c);
	return c;
}

static void find_chunks_share(void *context, size_t from, size_t to)
{
	const struct ts_contact_list *list = context;

	for (size_t c = from; c < to; c++)
		list->chunk[c] = chunk_of_particles(list, c * TS_CONTACT_CHUNK, particles_end(list, c));
}

static enum ts_status find_chunks(struct tsim *sim, struct ts_contact_list *list)
{
	list->chunks = list->n ? (list->particles + TS_CONTACT_CHUNK - 1) / TS_CONTACT_CHUNK : 0;
	TS_TRY(TS_RENEW(list->chunk, list->chunk_capacity, list->chunks));
	TS_TRY(TS_RENEW(list->chunk_summed, list->chunk_summed_capacity, list->chunks));
	ts_parallel(ts_team(sim, 4 * list->n), list->chunks, find_chunks_share, list);
	return TS_OK;
}

/* ---- slots that are reused */

struct slot_task {
	struct ts_contact_list *list;
	uint32_t *used; /* by share: number of slots that it needs */
	uint32_t *free; /* by active pair: stacks of free slots, one in each share */
};

/* Chunk c has been summed: frees the slots that no other particle has still to sum. Returns the number of
 * free slots. */
static size_t release_slots(const struct ts_contact_list *list, size_t c, uint32_t *free, size_t n)
{
	const struct ts_gather *g = &list->gather;
	size_t end = g->first[particles_end(list, c)];

	for (size_t k = g->first[c * TS_CONTACT_CHUNK]; k < end; k++) {
		uint32_t at = ts_contact_slot(list, g->entry[k] >> 1);

		if (at != TS_PAIR_INACTIVE && !--list->sums_left[at])
			free[n++] = list->active[at].slot;
	}
	return n;
}

/* Assigns slots in the order in which compute_share in contact_pass.c computes and sums. */
static void assign_slots(const struct slot_task *s, size_t share)
{
	struct ts_contact_list *list = s->list;
	const struct ts_contact_span *span = &list->span[share];
	uint32_t used = 0, *free = s->free + span->active;
	size_t c = 0, done, n = 0;

	for (size_t b = span->block; b < span->block_end; b++) {
		const struct ts_active_block *block = &list->block[b];
		size_t end = (size_t)block->first + block->n;

		for (size_t at = block->first; at < end; at++) {
			list->sums_left[at] = (uint8_t)(1 + ((size_t)list->active[at].j < list->particles));
			list->active[at].slot = n ? free[--n] : used++;
		}
		if (b + 1 < span->block_end && (b + 1 - span->block) % TS_BLOCKS_PER_SUM)
			continue;
		while ((done = ts_contact_chunk_done(list, span->active, end, &c)) < list->chunks)
			n = release_slots(list, done, free, n);
	}
	s->used[share] = used;
}

static void assign_shares_range(void *context, size_t from, size_t to)
{
	for (size_t k = from; k < to; k++)
		assign_slots(context, k);
}

/* Slots of a share follow those of the share before. */
static size_t offset_slots_by_share(const struct slot_task *s)
{
	struct ts_contact_list *list = s->list;
	size_t n = 0;

	for (size_t k = 0; k < (size_t)list->shares; k++) {
		for (size_t at = list->span[k].active; at < list->span[k].active_end && n; at++)
			list->active[at].slot += (uint32_t)n;
		n += s->used[k];
	}
	return n;
}

static enum ts_status assign_reused_slots(struct ts_contact_list *list, size_t *room)
{
	struct slot_task s = { list, ts_alloc((size_t)list->shares, sizeof *s.used),
			       ts_alloc(list->n, sizeof *s.free) };
	enum ts_status status = TS_NOMEM;

	if (s.used && s.free && TS_RENEW_UNSET(list->sums_left, list->sums_left_capacity, list->n) == TS_OK) {
		ts_parallel(list->shares, (size_t)list->shares, assign_shares_range, &s);
		*room = offset_slots_by_share(&s);
		status = TS_OK;
	}
	ts_free(s.used);
	ts_free(s.free);
	return status;
}

/* ---- slots that are kept */

/* Touching pairs first, in the order of the list; then the slot that is zero; then all other active pairs, which take
 * memory only where they begin to touch. Returns the number of touching pairs. */
static size_t assign_kept_slots(const struct ts_contact_list *list, size_t *room)
{
	uint32_t touching = 0, others;

	for (int k = 0; k < list->shares; k++)
		for (size_t b = list->span[k].block; b < list->span[k].block_end; b++)
			touching += list->block[b].touching;
	others = touching + 1;
	touching = 0;
	for (int k = 0; k < list->shares; k++)
		for (size_t b = list->span[k].block; b < list->span[k].block_end; b++) {
			const struct ts_active_block *block = &list->block[b];

			for (size_t at = 0; at < block->n; at++)
				list->active[block->first + at].slot =
					at < block->touching ? touching++ : others++;
		}
	*room = others - 1;
	return touching;
}

static void write_slots_share(void *context, size_t from, size_t to)
{
	const struct ts_contact_list *list = context;

	for (size_t k = from; k < to; k++)
		for (size_t at = list->span[k].active; at < list->span[k].active_end; at++)
			ts_contact_set_slot(list, list->active[at].row, list->active[at].slot);
}

/* ---- preparation of a force evaluation */

void ts_force_slots_forget(struct ts_contact_list *list)
{
	list->results = TS_RESULTS_NONE;
	ts_free(list->result);
	list->result = NULL;
	list->result_capacity = 0;
}

static void clear_share(void *context, size_t from, size_t to)
{
	struct ts_contact_list *list = context;

	if (to > from)
		memset(list->result + from, 0, (to - from) * sizeof *list->result);
}

/* Allocates `room` results and one that remains zero, that of slot `zero`; all before it are zero, too. */
static enum ts_status clear_results(const struct tsim *sim, struct ts_contact_list *list, size_t zero,
				    size_t room)
{
	size_t clear;

	list->zero_slot = (uint32_t)zero;
	list->parts = list->parts ? list->parts : 1;
	clear = (zero + 1) * (size_t)list->parts;
	TS_TRY(TS_RENEW_UNSET(list->result, list->result_capacity, (room + 1) * (size_t)list->parts));
	ts_parallel(ts_team(sim, 4 * clear), clear, clear_share, list);
	return TS_OK;
}

static enum ts_status assign_and_clear(struct tsim *sim, struct ts_contact_list *list, bool kept)
{
	size_t room, zero;

	TS_TRY(find_chunks(sim, list));
	TS_TRY(ts_touching_sums_reset(list));
	if (kept) {
		zero = assign_kept_slots(list, &room);
	} else {
		TS_TRY(assign_reused_slots(list, &room));
		zero = room;
	}
	ts_parallel(list->shares, (size_t)list->shares, write_slots_share, list);
	list->zero_slot = (uint32_t)zero;
	ts_parallel(ts_team(sim, 4 * list->n), list->particles, ts_touching_sums_renew, list);
	return clear_results(sim, list, zero, room);
}

enum ts_status ts_force_slots_prepare(struct tsim *sim, struct ts_contact_list *list, bool kept)
{
	enum ts_contact_results results = kept ? TS_RESULTS_KEPT : TS_RESULTS_PASSED;

	list->parted_history = sim->legacy == TS_LEGACY_LIGGGHTS || list->bridge_column;
	if (list->results == results && !ts_active_pairs_outdated(list))
		return TS_OK;
	if (!kept && list->results == TS_RESULTS_KEPT)
		ts_force_slots_forget(list);
	ts_contacts_store_history(sim, list);
	list->active_chosen = false; /* in case of failure */
	list->shares =
		ts_team(sim, 4 * list->n); /* a pair costs as much as several rounds of a simple loop */
	TS_TRY(ts_active_pairs_choose(sim, list));
	TS_TRY(ts_contacts_load_history(sim, list));
	/* with all results a step takes the most memory; parted pairs have history only here, see contact_loop.h */
	if (kept && !list->parted_history) {
		list->memory_newer = true;
		ts_contacts_forget_history(list);
		ts_alloc_trim();
	}
	if (assign_and_clear(sim, list, kept) != TS_OK)
		return ts_nomem(&sim->error);
	list->results = results;
	list->active_chosen = true;
	return TS_OK;
}

enum ts_status ts_force_slots_keep_all(struct tsim *sim, struct ts_contact_list *list)
{
	ts_contacts_store_history(sim, list);
	list->active_chosen = false;
	if (clear_results(sim, list, list->n, list->n) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t r = 0; r < list->n; r++)
		ts_contact_set_slot(list, r, (uint32_t)r);
	list->results = TS_RESULTS_KEPT;
	return TS_OK;
}
