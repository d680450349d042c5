/* The words of a search: small letters, without endings and words that stand everywhere, with their synonyms. */
#ifndef TS_MANUAL_SEARCH_QUERY_H
#define TS_MANUAL_SEARCH_QUERY_H

#include <stdbool.h>
#include <stddef.h>

#include "base/str.h"

enum { TS_QUERY_WORDS = 12 };

struct ts_query {
	struct ts_str phrase;		     /* all words, in small letters */
	struct ts_str word[TS_QUERY_WORDS];  /* as given */
	struct ts_str stem[TS_QUERY_WORDS];  /* a text has the word if a word of it begins with this */
	const char *synonym[TS_QUERY_WORDS]; /* counts, too, but less; or NULL */
	size_t n;
};

void ts_query_make(struct ts_query *query, const char *words);
void ts_query_release(struct ts_query *query);
/* Weighted number of times that word k begins a word of the text, which is in small letters. */
double ts_query_count(const struct ts_query *query, size_t k, const char *text, size_t length);

/* Which part of the pairs of successive words stand within some letters of each other, 0 to 1. */
double ts_query_near(const struct ts_query *query, const char *text, size_t length);
/* The word of the query that this one is, by its stem or its synonym, or query->n; stop is set if it says nothing. */
size_t ts_query_find(const struct ts_query *query, const char *word, bool *stop);

/* Appends the text in small letters. */
void ts_query_small_letters(const char *text, struct ts_str *out);

#endif
