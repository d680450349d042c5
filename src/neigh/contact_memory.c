#include "neigh/contact_memory.h"

#include "base/parallel.h"

#include "base/banned.h"

typedef void block_fn(const struct ts_contact_list *rows, const struct ts_active_block *block);

struct task {
	const struct ts_contact_list *rows;
	block_fn *work;
};

static void share(void *context, size_t from, size_t to)
{
	const struct task *t = context;

	for (size_t k = from; k < to; k++)
		for (size_t b = t->rows->span[k].block; b < t->rows->span[k].block_end; b++)
			t->work(t->rows, &t->rows->block[b]);
}

static void each_block(const struct tsim *sim, const struct ts_contact_list *rows, block_fn *work)
{
	struct task task = { rows, work };

	ts_parallel(ts_team(sim, rows->n), (size_t)rows->shares, share, &task);
}

static void settle(const struct ts_contact_list *rows, const struct ts_active_block *block)
{
	for (size_t c = 0; c < rows->history_width; c++)
		for (size_t at = 0; at < block->active; at++)
			*ts_contact_history(rows, block, at, c) = *ts_contact_memory(rows, block, at, c);
}

void ts_contacts_store_history(const struct tsim *sim, struct ts_contact_list *rows)
{
	if (rows->unsettled)
		each_block(sim, rows, settle);
	rows->unsettled = false;
}

static void recall(const struct ts_contact_list *rows, const struct ts_active_block *block)
{
	for (size_t c = 0; c < rows->history_width; c++) {
		for (size_t at = 0; at < block->active; at++)
			*ts_contact_memory(rows, block, at, c) = *ts_contact_history(rows, block, at, c);
		for (size_t at = block->active; at < ts_contact_column(block); at++)
			*ts_contact_memory(rows, block, at, c) = 0;
	}
}

/* Columns of a block begin at a whole vector behind those of the block before. */
static size_t place_blocks(const struct ts_contact_list *rows)
{
	size_t end = 0;

	for (int k = 0; k < rows->shares; k++)
		for (size_t b = rows->span[k].block; b < rows->span[k].block_end; b++) {
			rows->block[b].memory = end;
			end += ts_contact_column(&rows->block[b]) * rows->history_width;
		}
	return end;
}

enum ts_status ts_contacts_load_history(struct tsim *sim, struct ts_contact_list *rows)
{
	if (!rows->history_width)
		return TS_OK;
	if (TS_RENEW(rows->memory, rows->memory_capacity, place_blocks(rows)) != TS_OK)
		return ts_nomem(&sim->error);
	each_block(sim, rows, recall);
	return TS_OK;
}
