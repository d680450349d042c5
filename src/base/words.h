/* An input line split into words with their places. */
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

/* A slice of words; the function that makes it defines the owner of the texts. */
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

/* Appends copies to the words of *to. */
enum ts_status ts_words_append(struct ts_arena *arena, struct ts_words from, struct ts_words *to);

/* Concatenates two slices; the texts are not copied. */
enum ts_status ts_words_join(struct ts_arena *arena, struct ts_words a, struct ts_words b,
			     struct ts_words *out);

/* Splits a line of a data file at blanks; `#` starts a comment. Memory comes from the arena; all places
 * get the given file and text. */
enum ts_status ts_words_split(struct ts_arena *arena, const char *line, const struct ts_place *place,
			      struct ts_words *out);

#endif
