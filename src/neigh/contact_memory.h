/* Storage of the contact history.
 *
 * list->history has it by candidate pair; it is carried over when the list is rebuilt. While forces are
 * computed, the history of touching active pairs is in columns of their blocks (list->memory) instead, so
 * that the vectorised loops of contact laws load it for several contacts at once. In large lists the columns have room for
 * the pairs that touch and for some more; a block that needs more moves to memory that is reserved for it, but not in use. */
#ifndef TS_NEIGH_CONTACT_MEMORY_H
#define TS_NEIGH_CONTACT_MEMORY_H

#include "base/inline.h"
#include "neigh/contact_list.h"

/* Columns are padded to a multiple of this. */
enum { TS_MEMORY_VECTOR = 8 };

/* History number c of the touching pair `at` of the block; that of the next pair follows in memory. */
TS_INLINE double *ts_contact_memory(const struct ts_active_block *block, size_t at, size_t c)
{
	return &block->memory[c * block->column + at];
}

/* The same number in list->history. */
TS_INLINE double *ts_contact_history(const struct ts_contact_list *list, const struct ts_active_block *block,
				     size_t at, size_t c)
{
	return &list->history[list->active[block->first + at].row * list->history_width + c];
}

/* Makes the columns of the block, of which all are in use, long enough for all of its pairs. */
void ts_contact_memory_extend(const struct ts_contact_list *list, struct ts_active_block *block);
/* The history of all touching pairs is in the columns now and that of all others is zero: the memory of list->history
 * is given back until ts_contacts_store_history writes to it. */
void ts_contacts_forget_history(struct ts_contact_list *list);
/* Copies the columns back to list->history; to be called before anything reads the history there. */
void ts_contacts_store_history(const struct tsim *sim, struct ts_contact_list *list);
/* Allocates the columns of the blocks and copies the history of the touching pairs into them. */
enum ts_status ts_contacts_load_history(struct tsim *sim, struct ts_contact_list *list);

#endif
