/* Strings: a string builder, strict number parsing, spelling suggestions, and a pool of unique strings. */
#ifndef TS_BASE_STR_H
#define TS_BASE_STR_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/alloc.h"

/* A string builder; zero-initialise. After an allocation failure `failed` stays set and further
 * additions have no effect, so a single check at the end is sufficient. text is not NULL after the
 * first successful addition; ts_str_text returns "" for an empty one. */
struct ts_str {
	char *text;
	size_t length, capacity;
	bool failed;
};
void ts_str_add(struct ts_str *s, const char *text);
void ts_str_add_n(struct ts_str *s, const char *text, size_t n);
void ts_str_addf(struct ts_str *s, const char *format, ...) __attribute__((format(printf, 2, 3)));
void ts_str_vaddf(struct ts_str *s, const char *format, va_list args) __attribute__((format(printf, 2, 0)));
void ts_str_clear(struct ts_str *s);   /* empty; the memory is kept */
void ts_str_release(struct ts_str *s); /* empty; the memory is freed */
const char *ts_str_text(const struct ts_str *s);

/* Parses a string that must be one number in C notation (no hexadecimal, no trailing characters); nan
 * and inf are refused. */
bool ts_parse_real(const char *text, double *out);
bool ts_parse_int(const char *text, int64_t *out);

bool ts_streq(const char *a, const char *b);
bool ts_ends_with(const char *text, const char *ending);
/* Whether the text contains the word, between blanks or ends of lines. */
bool ts_has_word(const char *text, const char *word);
/* Shell-like pattern matching with `*` only. */
bool ts_glob(const char *pattern, const char *text);

/* Finds the candidate closest in spelling (Damerau-Levenshtein distance). Usage:
 *   struct ts_suggest s = ts_suggest_start(word); ts_suggest_try(&s, name) ...;
 *   "...%s", ts_suggest_text(&s)
 * gives "; did you mean 'name'?", else the candidates if they are few ("; known: a, b, c"), else "". */
struct ts_suggest {
	const char *word, *best;
	size_t distance;
	char text[96], list[80];
	bool many; /* the list is too long */
};
struct ts_suggest ts_suggest_start(const char *word);
void ts_suggest_try(struct ts_suggest *s, const char *candidate);
const char *ts_suggest_text(struct ts_suggest *s);

/* A pool of unique strings; they live until the pool is freed. */
struct ts_pool;
struct ts_pool *ts_pool_new(void);
const char *ts_pool_get(struct ts_pool *pool, const char *text); /* NULL: out of memory */
void ts_pool_free(struct ts_pool *pool);

#endif
