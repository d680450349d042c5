/* Storage of the contact history.
 *
 * list->history has it by candidate pair; it is carried over when the list is rebuilt. Only pairs that touched when it was
 * written have an entry there, one after the other; all others share one that is zero. Where pairs that do not touch may have
 * history, too, all have an entry.
 *
 * While forces are computed, the history of touching active pairs is in columns of their blocks (list->memory) instead, so
 * that the vectorised loops of contact laws load it for several contacts at once; list->history is out of date then, and its
 * memory is given back. In large lists the columns have room for the pairs that touch and for some more; a block that needs
 * more moves to memory that is reserved for it, but not in use. */
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

/* The history of pair r, history_width > 0 numbers. The first entry is that which is zero. */
TS_INLINE double *ts_contact_history(const struct ts_contact_list *list, size_t r)
{
	const struct ts_history_word *word = &list->history_word[r / 64];
	uint64_t mark = (uint64_t)1 << r % 64;
	size_t place = 0;

	if (list->history_by_pair)
		place = r + 1;
	else if (word->marks & mark)
		place = 1 + word->first + (size_t)__builtin_popcountll(word->marks & (mark - 1));
	return list->history + place * list->history_width;
}

/* Makes the columns of the block, of which all are in use, long enough for all of its pairs. */
void ts_contact_memory_extend(const struct ts_contact_list *list, struct ts_active_block *block);
/* Gives the pairs that touch now entries, whose numbers are not set, and all others none. */
void ts_contacts_note_history(const struct tsim *sim, struct ts_contact_list *list);
/* Number of pairs that have entries, unless all have. */
size_t ts_contacts_with_history(const struct ts_contact_list *list);
/* Room for the history of n pairs, of which none has any. by_pair: all will have entries. */
enum ts_status ts_contacts_reserve_history(struct ts_contact_list *list, size_t n, bool by_pair);
/* Gives all pairs entries; those that had none are zero. */
void ts_contacts_spread_history(struct ts_contact_list *list);
/* To be called when nothing needs what is in list->history: its memory is given back until it is written again. Short lists
 * keep it. */
void ts_contacts_give_history_back(struct ts_contact_list *list);
/* Copies the columns back to list->history; to be called before anything reads the history there. */
void ts_contacts_store_history(const struct tsim *sim, struct ts_contact_list *list);
/* Allocates the columns of the blocks and copies the history of the touching pairs into them. */
enum ts_status ts_contacts_load_history(struct tsim *sim, struct ts_contact_list *list);

#endif
