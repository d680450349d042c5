/* Where contacts remember.
 *
 * What rows remember belongs to them: rows->history, which goes with them from list to list. While near rows are
 * computed the active ones have it in columns of their blocks instead: numbers that a law needs for several contacts at
 * once stand side by side, and follow each other in memory as the contacts do. */
#ifndef TS_NEIGH_ROW_MEMORY_H
#define TS_NEIGH_ROW_MEMORY_H

#include "base/inline.h"
#include "neigh/rows.h"

/* Columns are as long as whole vectors; what stands behind the active rows is nothing. */
enum { TS_ROW_VECTOR = 8 };

TS_INLINE size_t ts_row_column(const struct ts_row_block *block)
{
	return (block->n + TS_ROW_VECTOR - 1) & ~(size_t)(TS_ROW_VECTOR - 1);
}

/* Number c of the active row that stands at `at`; that of the next one follows. */
TS_INLINE double *ts_row_memory(const struct ts_rows *rows, const struct ts_row_block *block, size_t at, size_t c)
{
	return &rows->memory[block->memory + c * ts_row_column(block) + at];
}

/* Number c of the history of the row that stands at `at`. */
TS_INLINE double *ts_row_history(const struct ts_rows *rows, const struct ts_row_block *block, size_t at, size_t c)
{
	return &rows->history[rows->near[block->first + at].row * rows->history_width + c];
}

/* Brings the history of all rows up to date: before somebody looks at it. */
void ts_rows_settle(const struct tsim *sim, struct ts_rows *rows);
/* Columns for the blocks, and what their active rows remember. */
enum ts_status ts_rows_recall(struct tsim *sim, struct ts_rows *rows);

#endif
