/* A line of input cut into words that know where they stood. */
#ifndef TS_BASE_WORDS_H
#define TS_BASE_WORDS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"
#include "base/str.h"

struct ts_word {
	const char *text; /* quotes stripped, variables substituted */
	struct ts_place place;
	bool quoted;
};

/* A slice of words; who owns the texts is said by the function that makes it. */
struct ts_words {
	const struct ts_word *word;
	size_t n;
};

/* The words from the k-th on. */
static inline struct ts_words ts_words_from(struct ts_words all, size_t k)
{
	return (struct ts_words){ all.word + k, k < all.n ? all.n - k : 0 };
}

/* Copies texts and slice into the arena. */
enum ts_status ts_words_copy(struct ts_arena *arena, struct ts_words from, struct ts_words *to);

/* The same, behind the words that *to has already. */
enum ts_status ts_words_append(struct ts_arena *arena, struct ts_words from, struct ts_words *to);

/* One slice after the other; the texts are shared. */
enum ts_status ts_words_join(struct ts_arena *arena, struct ts_words a, struct ts_words b,
			     struct ts_words *out);

/* Cuts a line of a data file at blanks; `#` starts a comment. Memory comes from the arena; file and
 * text in the places are kept as given. */
enum ts_status ts_words_split(struct ts_arena *arena, const char *line, const struct ts_place *place,
			      struct ts_words *out);

#endif
