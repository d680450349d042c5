#include "neigh/contact_memory.h"

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

	ts_parallel(ts_team(sim, list->n), (size_t)list->shares, run_share, &task);
}

static void store_block(const struct ts_contact_list *list, const struct ts_active_block *block)
{
	for (size_t c = 0; c < list->history_width; c++)
		for (size_t at = 0; at < block->touching; at++)
			*ts_contact_history(list, block, at, c) = *ts_contact_memory(list, block, at, c);
}

void ts_contacts_store_history(const struct tsim *sim, struct ts_contact_list *list)
{
	if (list->memory_newer)
		for_each_block(sim, list, store_block);
	list->memory_newer = false;
}

static void load_block(const struct ts_contact_list *list, const struct ts_active_block *block)
{
	for (size_t c = 0; c < list->history_width; c++) {
		for (size_t at = 0; at < block->touching; at++)
			*ts_contact_memory(list, block, at, c) = *ts_contact_history(list, block, at, c);
		for (size_t at = block->touching; at < ts_contact_column(block); at++)
			*ts_contact_memory(list, block, at, c) = 0;
	}
}

/* The columns of a block follow those of the block before, aligned to whole vectors. */
static size_t place_blocks(const struct ts_contact_list *list)
{
	size_t end = 0;

	for (int k = 0; k < list->shares; k++)
		for (size_t b = list->span[k].block; b < list->span[k].block_end; b++) {
			list->block[b].memory = end;
			end += ts_contact_column(&list->block[b]) * list->history_width;
		}
	return end;
}

enum ts_status ts_contacts_load_history(struct tsim *sim, struct ts_contact_list *list)
{
	if (!list->history_width)
		return TS_OK;
	if (TS_RENEW_UNSET(list->memory, list->memory_capacity, place_blocks(list)) != TS_OK)
		return ts_nomem(&sim->error);
	for_each_block(sim, list, load_block);
	return TS_OK;
}

void ts_contacts_forget_history(struct ts_contact_list *list)
{
	if (list->history_width)
		ts_alloc_forget(list->history, list->capacity * list->history_width * sizeof *list->history);
}
