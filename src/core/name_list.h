/* A list of words, each one of a table of names, such as the columns of an output. */
#ifndef TS_CORE_NAME_LIST_H
#define TS_CORE_NAME_LIST_H

#include "core/sim.h"

struct ts_name_list {
	size_t n;
	int *item; /* index into the table; in the arena */
};

/* Reads words that are names of a table. `what` is the name of the owner for messages. `stride` is the
 * distance of names in bytes: the table may consist of structs that begin with the name; it is closed by
 * NULL. */
enum ts_status ts_name_list_read(struct tsim *sim, const char *what, struct ts_arena *arena,
				 struct ts_words words, const void *table, size_t stride,
				 struct ts_name_list *out);
/* Its parts, for lists that may have other words, too: allocate room for n names; find the index of a
 * word. */
enum ts_status ts_name_list_room(struct tsim *sim, struct ts_arena *arena, size_t n,
				 struct ts_name_list *out);
enum ts_status ts_name_list_find(struct tsim *sim, const char *what, const struct ts_word *word,
				 const void *table, size_t stride, int *index);

/* Fails at the first word that is not among the keywords `names`, closed by NULL: "compute pe: unknown "
										   "keyword 'x'". */
enum ts_status ts_name_list_check_keywords(struct tsim *sim, const char *what, struct ts_words words,
					   const char *const *names);

#endif
