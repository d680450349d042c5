#include "neigh/force_slots.h"

#include <string.h>

#include "base/parallel.h"
#include "neigh/active_pairs.h"
#include "neigh/contact_memory.h"
#include "neigh/touching_sums.h"
#include "particle/particles.h"

#include "base/banned.h"

/* ---- which active pairs each chunk of particles has */

struct chunk_task {
	const struct ts_contact_list *list;
	struct ts_contact_chunk *part; /* by share and chunk: the pairs of the share */
};

static void note_pair(struct ts_contact_chunk *chunk, int32_t particle, size_t at)
{
	struct ts_contact_chunk *c = &chunk[particle / TS_CONTACT_CHUNK];

	if (!c->end)
		c->first = at;
	c->end = at + 1;
}

static void find_parts_shares(void *context, size_t from, size_t to)
{
	const struct chunk_task *t = context;
	const struct ts_contact_list *list = t->list;

	for (size_t k = from; k < to; k++) {
		struct ts_contact_chunk *part = t->part + k * list->chunks;

		for (size_t at = list->span[k].active; at < list->span[k].active_end; at++) {
			note_pair(part, list->active[at].i, at);
			if ((size_t)list->active[at].j < list->particles)
				note_pair(part, list->active[at].j, at);
		}
	}
}

static void join_parts_range(void *context, size_t from, size_t to)
{
	const struct chunk_task *t = context;
	const struct ts_contact_list *list = t->list;

	for (size_t c = from; c < to; c++) {
		struct ts_contact_chunk *chunk = &list->chunk[c];

		*chunk = t->part[c];
		for (size_t k = 1; k < (size_t)list->shares; k++) {
			const struct ts_contact_chunk *part = &t->part[k * list->chunks + c];

			if (!part->end)
				continue;
			chunk->divided = chunk->end > 0;
			chunk->first = chunk->end ? chunk->first : part->first;
			chunk->end = part->end;
		}
	}
}

static enum ts_status find_chunks(struct tsim *sim, struct ts_contact_list *list)
{
	struct chunk_task task = { .list = list };

	list->chunks = list->n ? (list->particles + TS_CONTACT_CHUNK - 1) / TS_CONTACT_CHUNK : 0;
	TS_TRY(TS_RENEW(list->chunk, list->chunk_capacity, list->chunks));
	TS_TRY(TS_RENEW(list->chunk_summed, list->chunk_summed_capacity, list->chunks));
	task.part = ts_alloc((size_t)list->shares * list->chunks, sizeof *task.part);
	if (!task.part)
		return TS_NOMEM;
	ts_parallel(list->shares, (size_t)list->shares, find_parts_shares, &task);
	ts_parallel(ts_team(sim, list->chunks), list->chunks, join_parts_range, &task);
	ts_free(task.part);
	return TS_OK;
}

/* ---- slots that are reused */

struct slot_task {
	struct ts_contact_list *list;
	uint32_t *used; /* by share: number of slots that it needs */
	/* Pairs are linked to the chunk that sums them last, then, as their slots are free, to the pair whose slot became free
	 * before. By active pair: index + 1 of the next one, 0: none; by share and chunk: the first one. */
	uint32_t *next, *last_summed;
};

/* Links the pair, unless one of its chunks is in other shares, too, and so is summed after all pairs. */
static void link_pair(const struct slot_task *s, uint32_t *last_summed, size_t at)
{
	const struct ts_contact_list *list = s->list;
	size_t i = (size_t)list->active[at].i, j = (size_t)list->active[at].j;
	size_t a = i / TS_CONTACT_CHUNK, b = j < list->particles ? j / TS_CONTACT_CHUNK : a,
	       last = a > b ? a : b;

	if (list->chunk[a].divided || list->chunk[b].divided)
		return;
	s->next[at] = last_summed[last];
	last_summed[last] = (uint32_t)at + 1;
}

/* Assigns slots in the order in which compute_share in contact_pass.c computes and sums. */
static void assign_slots(const struct slot_task *s, size_t share)
{
	struct ts_contact_list *list = s->list;
	const struct ts_contact_span *span = &list->span[share];
	uint32_t used = 0, free = 0 /* pair + 1 */, *last_summed = s->last_summed + share * list->chunks;
	size_t c = 0, done;

	for (size_t b = span->block; b < span->block_end; b++) {
		const struct ts_active_block *block = &list->block[b];
		size_t end = (size_t)block->first + block->n;

		for (size_t at = block->first; at < end; at++) {
			link_pair(s, last_summed, at);
			list->active[at].slot = free ? list->active[free - 1].slot : used++;
			free = free ? s->next[free - 1] : 0;
		}
		if (b + 1 < span->block_end && (b + 1 - span->block) % TS_BLOCKS_PER_SUM)
			continue;
		while ((done = ts_contact_chunk_done(list, span->active, end, &c)) < list->chunks)
			for (uint32_t at = last_summed[done], next; at; at = next) {
				next = s->next[at - 1];
				s->next[at - 1] = free;
				free = at;
			}
	}
	s->used[share] = used;
}

static void assign_shares_range(void *context, size_t from, size_t to)
{
	for (size_t k = from; k < to; k++)
		assign_slots(context, k);
}

/* Slots of a share follow those of the share before. */
static void offset_slots_shares(void *context, size_t from, size_t to)
{
	const struct slot_task *s = context;
	const struct ts_contact_list *list = s->list;

	for (size_t k = from; k < to; k++) {
		uint32_t before = 0;

		for (size_t share = 0; share < k; share++)
			before += s->used[share];
		for (size_t at = list->span[k].active; at < list->span[k].active_end && before; at++)
			list->active[at].slot += before;
	}
}

static enum ts_status assign_reused_slots(struct ts_contact_list *list, size_t *room)
{
	struct slot_task s = { list, ts_alloc((size_t)list->shares, sizeof *s.used),
			       ts_alloc_unset(list->n, sizeof *s.next),
			       ts_alloc((size_t)list->shares * list->chunks, sizeof *s.last_summed) };
	enum ts_status status = TS_NOMEM;

	if (s.used && s.next && s.last_summed) {
		ts_parallel(list->shares, (size_t)list->shares, assign_shares_range, &s);
		ts_parallel(list->shares, (size_t)list->shares, offset_slots_shares, &s);
		*room = 0;
		for (int k = 0; k < list->shares; k++)
			*room += s.used[k];
		status = TS_OK;
	}
	ts_free(s.used);
	ts_free(s.next);
	ts_free(s.last_summed);
	return status;
}

/* ---- slots that are kept */

/* Touching pairs first, in the order of the list; then the slot that is zero. All other active pairs get one when they begin
 * to touch (contact_loop.h), so that the slots in use follow one another, and only they take memory. *zero: the number of
 * touching pairs; *room: that of active pairs. */
static enum ts_status assign_kept_slots(struct ts_contact_list *list, size_t *zero, size_t *room)
{
	uint32_t touching = 0;

	*room = 0;
	for (int k = 0; k < list->shares; k++)
		for (size_t b = list->span[k].block; b < list->span[k].block_end; b++) {
			const struct ts_active_block *block = &list->block[b];

			for (size_t at = 0; at < block->n; at++)
				list->active[block->first + at].slot =
					at < block->touching ? touching++ : (uint32_t)TS_PAIR_INACTIVE;
			*room += block->n;
		}
	*zero = touching;
	if (!list->next_slot)
		list->next_slot = ts_alloc_aligned(1, sizeof *list->next_slot);
	if (!list->next_slot)
		return TS_NOMEM;
	*list->next_slot = touching + 1;
	return TS_OK;
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
	bool kept = list->results == TS_RESULTS_KEPT;

	list->results = TS_RESULTS_NONE;
	if (!kept)
		return;
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
		TS_TRY(assign_kept_slots(list, &zero, &room));
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
	if (!list->history_by_pair) { /* else pairs that do not touch have history only there */
		list->memory_newer = list->history_width > 0;
		ts_contacts_give_history_back(list);
		if (kept) /* such a step takes the most memory */
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
