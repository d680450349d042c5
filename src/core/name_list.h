/* A list of words, each one of a table of names: the columns a user wants. */
#ifndef TS_CORE_NAME_LIST_H
#define TS_CORE_NAME_LIST_H

#include "core/sim.h"

struct ts_name_list {
	size_t n;
	int *item; /* index into the table; in the arena */
};

/* `what` names the owner in messages, `stride` is the distance of the names in bytes: the table may be
 * one of structs that begin with the name, closed by NULL. */
enum ts_status ts_name_list_read(struct tsim *sim, const char *what, struct ts_arena *arena,
				 struct ts_words words, const void *table, size_t stride,
				 struct ts_name_list *out);
/* Its parts, for lists in which other words may stand as well: room for so many, and which name a word is. */
enum ts_status ts_name_list_room(struct tsim *sim, struct ts_arena *arena, size_t n,
				 struct ts_name_list *out);
enum ts_status ts_name_list_find(struct tsim *sim, const char *what, const struct ts_word *word,
				 const void *table, size_t stride, int *index);

#endif
