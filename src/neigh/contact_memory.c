#include "neigh/contact_memory.h"

#include <string.h>

#include "base/clones.h"
#include "base/parallel.h"

#include "base/banned.h"

typedef void block_fn(const struct ts_contact_list *list, const struct ts_active_block *block);

struct block_task {
	const struct ts_contact_list *list;
	block_fn *function;
};

static void run_share(void *context, size_t from, size_t to)
{
	const struct block_task *t = context;

	for (size_t k = from; k < to; k++)
		for (size_t b = t->list->span[k].block; b < t->list->span[k].block_end; b++)
			t->function(t->list, &t->list->block[b]);
}

static void for_each_block(const struct tsim *sim, const struct ts_contact_list *list, block_fn *function)
{
	struct block_task task = { list, function };

	ts_parallel(ts_team(sim, 4 * list->n), (size_t)list->shares, run_share, &task);
}

/* ---- list->history */

/* Which of n <= 64 pairs touch. */
TS_INLINE uint64_t marks_of(const uint32_t *slot, size_t n)
{
	uint64_t marks = 0;

#pragma omp simd reduction(| : marks)
	for (size_t k = 0; k < n; k++)
		marks |= (uint64_t)(slot[k] & 1) << k;
	return marks;
}

TS_CLONES static void mark_words(struct ts_contact_list *list, size_t from, size_t to)
{
	for (size_t w = from; w < to; w++) {
		const uint32_t *slot = list->slot + 64 * w;
		size_t left = list->n - 64 * w;

		list->history_word[w].marks = left < 64 ? marks_of(slot, left) : marks_of(slot, 64);
	}
}

static void mark_share(void *context, size_t from, size_t to)
{
	mark_words(context, from, to);
}

void ts_contacts_note_history(const struct tsim *sim, struct ts_contact_list *list)
{
	size_t words = (list->n + 63) / 64;
	uint32_t entries = 0;

	if (list->history_by_pair || !list->history_width)
		return;
	ts_parallel(ts_team(sim, 4 * list->n), words, mark_share, list);
	for (size_t w = 0; w < words; w++) {
		list->history_word[w].first = entries;
		entries += (uint32_t)__builtin_popcountll(list->history_word[w].marks);
	}
}

size_t ts_contacts_with_history(const struct ts_contact_list *list)
{
	const struct ts_history_word *last;

	if (!list->n || !list->history_width)
		return 0;
	last = &list->history_word[(list->n - 1) / 64];
	return last->first + (size_t)__builtin_popcountll(last->marks);
}

enum ts_status ts_contacts_reserve_history(struct ts_contact_list *list, size_t n, bool by_pair)
{
	size_t width = list->history_width, words = (n + 63) / 64;

	list->history_by_pair = by_pair;
	if (!width)
		return TS_OK;
	TS_TRY(TS_RENEW_UNSET(list->history, list->history_capacity, (n + 1) * width));
	TS_TRY(TS_RENEW_UNSET(list->history_word, list->history_word_capacity, words));
	memset(list->history, 0, (by_pair ? n + 1 : 1) * width * sizeof *list->history);
	if (words)
		memset(list->history_word, 0, words * sizeof *list->history_word);
	return TS_OK;
}

/* From the last pair to the first: an entry moves to a place that is not before it. */
void ts_contacts_spread_history(struct ts_contact_list *list)
{
	size_t width = list->history_width;

	if (list->history_by_pair)
		return;
	for (size_t r = list->n; width && r-- > 0;) {
		const double *from = ts_contact_history(list, r);

		for (size_t c = 0; c < width; c++)
			list->history[(r + 1) * width + c] = from[c];
	}
	list->history_by_pair = true;
}

/* Bytes. Below it the time that the system needs to map memory anew counts, and the memory does not. */
enum { WORTH_GIVING_BACK = 3 << 19 };

void ts_contacts_give_history_back(struct ts_contact_list *list)
{
	size_t bytes = (ts_contacts_with_history(list) + 1) * list->history_width * sizeof *list->history;

	if (bytes >= WORTH_GIVING_BACK && !list->history_by_pair)
		ts_alloc_clear(list->history, bytes);
}

static void store_block(const struct ts_contact_list *list, const struct ts_active_block *block)
{
	for (size_t at = 0; at < block->touching; at++) {
		double *to = ts_contact_history(list, list->active[block->first + at].row);

		for (size_t c = 0; c < list->history_width; c++)
			to[c] = *ts_contact_memory(block, at, c);
	}
}

void ts_contacts_store_history(const struct tsim *sim, struct ts_contact_list *list)
{
	if (list->memory_newer) {
		ts_contacts_note_history(sim, list);
		for_each_block(sim, list, store_block);
	}
	list->memory_newer = false;
}

static void load_block(const struct ts_contact_list *list, const struct ts_active_block *block)
{
	for (size_t at = 0; at < block->touching; at++) {
		const double *from = ts_contact_history(list, list->active[block->first + at].row);

		for (size_t c = 0; c < list->history_width; c++)
			*ts_contact_memory(block, at, c) = from[c];
	}
	for (size_t c = 0; c < list->history_width; c++)
		for (size_t at = block->touching; at < block->column; at++)
			*ts_contact_memory(block, at, c) = 0;
}

/* ---- columns */

/* Numbers. LARGE: below it columns have room for all pairs of their blocks. */
enum { LARGE = 1 << 17 };

static uint32_t whole_vectors(uint32_t n)
{
	return (n + TS_MEMORY_VECTOR - 1) & ~(uint32_t)(TS_MEMORY_VECTOR - 1);
}

/* Length of the columns of a block. Within the lifetime of a list of active pairs few contacts begin. */
static uint32_t choose_column(const struct ts_active_block *block, bool whole)
{
	uint32_t all = whole_vectors(block->n),
		 some = whole_vectors(block->touching + block->touching / 8 + TS_MEMORY_VECTOR);

	return whole || all < some ? all : some;
}

/* Sets the lengths of the columns; returns the number of all their elements. */
static size_t size_blocks(const struct ts_contact_list *list, bool whole)
{
	size_t n = 0;

	for (int k = 0; k < list->shares; k++)
		for (size_t b = list->span[k].block; b < list->span[k].block_end; b++) {
			list->block[b].column = choose_column(&list->block[b], whole);
			n += list->block[b].column;
		}
	return n * list->history_width;
}

/* The columns of a block follow those of the block before, aligned to whole vectors. */
static void place_blocks(const struct ts_contact_list *list)
{
	double *end = list->memory;

	for (int k = 0; k < list->shares; k++)
		for (size_t b = list->span[k].block; b < list->span[k].block_end; b++) {
			list->block[b].memory = end;
			end += list->block[b].column * list->history_width;
		}
}

/* Where the columns of a block are in `spare`: blocks are in the order of their active pairs, so they are at least as far
 * apart as their columns, padded, are long. */
static size_t place_in_spare(const struct ts_contact_list *list, const struct ts_active_block *block)
{
	size_t before = block->first + (size_t)(block - list->block) * TS_MEMORY_VECTOR,
	       misplaced = (uintptr_t)list->spare / sizeof *list->spare % TS_MEMORY_VECTOR;

	return before / TS_MEMORY_VECTOR * TS_MEMORY_VECTOR * list->history_width + TS_MEMORY_VECTOR -
	       misplaced;
}

void ts_contact_memory_extend(const struct ts_contact_list *list, struct ts_active_block *block)
{
	uint32_t column = whole_vectors(block->n);
	double *to = list->spare + place_in_spare(list, block);

	for (size_t c = 0; c < list->history_width; c++)
		for (size_t at = 0; at < column; at++)
			to[c * column + at] = at < block->touching ? *ts_contact_memory(block, at, c) : 0;
	block->memory = to;
	block->column = column;
}

/* Reserves the columns. Those in `spare` are in use only where they are written to. */
static enum ts_status reserve_columns(struct ts_contact_list *list)
{
	size_t n = size_blocks(list, true);
	bool large = n > LARGE;

	ts_free(list->spare);
	list->spare = NULL;
	if (large) {
		list->spare = ts_alloc((list->n + TS_MEMORY_VECTOR * (list->block_capacity + 3)) *
					       list->history_width,
				       sizeof *list->spare);
		if (!list->spare)
			return TS_NOMEM;
		n = size_blocks(list, false);
	}
	TS_TRY(TS_RENEW_UNSET(list->memory, list->memory_capacity, n));
	place_blocks(list);
	return TS_OK;
}

enum ts_status ts_contacts_load_history(struct tsim *sim, struct ts_contact_list *list)
{
	if (!list->history_width)
		return TS_OK;
	if (reserve_columns(list) != TS_OK)
		return ts_nomem(&sim->error);
	for_each_block(sim, list, load_block);
	return TS_OK;
}
