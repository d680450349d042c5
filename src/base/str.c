#include "base/str.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/banned.h"

void ts_str_add_n(struct ts_str *s, const char *text, size_t n)
{
	if (s->failed || ts_grow_text(&s->text, &s->capacity, s->length + n + 1) != TS_OK) {
		s->failed = true;
		return;
	}
	memcpy(s->text + s->length, text, n);
	s->length += n;
	s->text[s->length] = '\0';
}

void ts_str_add(struct ts_str *s, const char *text)
{
	ts_str_add_n(s, text, strlen(text));
}

void ts_str_vaddf(struct ts_str *s, const char *format, va_list args)
{
	va_list again;
	int n;

	va_copy(again, args);
	n = vsnprintf(NULL, 0, format, again);
	va_end(again);
	if (n < 0 || s->failed || ts_grow_text(&s->text, &s->capacity, s->length + (size_t)n + 1) != TS_OK) {
		s->failed = true;
		return;
	}
	vsnprintf(s->text + s->length, (size_t)n + 1, format, args);
	s->length += (size_t)n;
}

void ts_str_addf(struct ts_str *s, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	ts_str_vaddf(s, format, args);
	va_end(args);
}

void ts_str_clear(struct ts_str *s)
{
	s->length = 0;
	if (s->text)
		s->text[0] = '\0';
}

void ts_str_release(struct ts_str *s)
{
	ts_free(s->text);
	*s = (struct ts_str){ 0 };
}

const char *ts_str_text(const struct ts_str *s)
{
	return s->text ? s->text : "";
}

bool ts_parse_int(const char *text, int64_t *out)
{
	enum { CERTAIN = 18 }; /* digits that do not overflow */
	const char *p = text + (*text == '-');
	char *end;
	long long value = 0;

	for (; *p >= '0' && *p <= '9'; p++)
		value = p - text < CERTAIN ? 10 * value + (*p - '0') : 0;
	if (!*p && p - text <= CERTAIN && p - text > (*text == '-')) {
		*out = *text == '-' ? -value : value;
		return true;
	}
	if (!*text || strspn(text, "0123456789+-") != strlen(text))
		return false;
	errno = 0;
	value = strtoll(text, &end, 10);
	if (*end || errno)
		return false;
	*out = value;
	return true;
}

bool ts_streq(const char *a, const char *b)
{
	return strcmp(a, b) == 0;
}

bool ts_ends_with(const char *text, const char *ending)
{
	size_t n = strlen(text), m = strlen(ending);

	return n >= m && ts_streq(text + n - m, ending);
}

bool ts_has_word(const char *text, const char *word)
{
	size_t length = strlen(word);

	for (const char *at = text; (at = strstr(at, word)); at += length)
		if ((at == text || strchr(" \n", at[-1])) && strchr(" \n", at[length]))
			return true;
	return false;
}

bool ts_glob(const char *pattern, const char *text)
{
	const char *star = strchr(pattern, '*');
	size_t head;

	if (!star)
		return ts_streq(pattern, text);
	head = (size_t)(star - pattern);
	if (strncmp(pattern, text, head) != 0)
		return false;
	for (const char *rest = text + head;; rest++) {
		if (ts_glob(star + 1, rest))
			return true;
		if (!*rest)
			return false;
	}
}

enum { LONGEST_WORD = 48 };

static size_t minimum3(size_t a, size_t b, size_t c)
{
	size_t m = a < b ? a : b;

	return m < c ? m : c;
}

/* Optimal string alignment distance: insertions, deletions, substitutions, adjacent swaps. */
static size_t edit_distance(const char *a, const char *b)
{
	size_t n = strlen(a), m = strlen(b);
	size_t d[3][LONGEST_WORD + 1];

	if (n > LONGEST_WORD || m > LONGEST_WORD)
		return LONGEST_WORD;
	for (size_t j = 0; j <= m; j++)
		d[0][j] = j;
	for (size_t i = 1; i <= n; i++) {
		size_t *now = d[i % 3], *last = d[(i + 2) % 3], *before = d[(i + 1) % 3];

		now[0] = i;
		for (size_t j = 1; j <= m; j++) {
			now[j] = minimum3(last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1]));
			if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] &&
			    before[j - 2] + 1 < now[j])
				now[j] = before[j - 2] + 1;
		}
	}
	return d[n % 3][m];
}

struct ts_suggest ts_suggest_start(const char *word)
{
	size_t n = strlen(word), tolerance = n > 1 ? (n + 2) / 3 : 0;

	return (struct ts_suggest){ .word = word, .distance = tolerance + 1 };
}

void ts_suggest_try(struct ts_suggest *s, const char *candidate)
{
	size_t d = edit_distance(s->word, candidate), used = strlen(s->list);
	size_t left = sizeof s->list - used;

	s->many |= strlen(candidate) + 2 >= left;
	if (!s->many)
		snprintf(s->list + used, left, "%s%s", used ? ", " : "", candidate);
	if (d < s->distance) {
		s->distance = d;
		s->best = candidate;
	}
}

const char *ts_suggest_text(struct ts_suggest *s)
{
	if (s->best)
		snprintf(s->text, sizeof s->text, "; did you mean '%s'?", s->best);
	else if (*s->list && !s->many)
		snprintf(s->text, sizeof s->text, "; known: %.80s", s->list);
	return s->text;
}

struct ts_pool {
	char **slot; /* open addressing, linear probing */
	size_t size, used;
	struct ts_arena arena;
};

static uint64_t hash_text(const char *text)
{
	uint64_t h = 0xcbf29ce484222325u; /* FNV-1a */

	for (; *text; text++)
		h = (h ^ (unsigned char)*text) * 0x100000001b3u;
	return h;
}

static char **find_slot(char **slot, size_t size, const char *text)
{
	size_t k = hash_text(text) & (size - 1);

	while (slot[k] && !ts_streq(slot[k], text))
		k = (k + 1) & (size - 1);
	return &slot[k];
}

struct ts_pool *ts_pool_new(void)
{
	struct ts_pool *pool = ts_alloc(1, sizeof *pool);

	if (!pool)
		return NULL;
	pool->size = 64;
	pool->slot = ts_alloc(pool->size, sizeof *pool->slot);
	if (!pool->slot) {
		ts_free(pool);
		return NULL;
	}
	return pool;
}

static bool enlarge_pool(struct ts_pool *pool)
{
	size_t size = 2 * pool->size;
	char **slot = ts_alloc(size, sizeof *slot);

	if (!slot)
		return false;
	for (size_t k = 0; k < pool->size; k++)
		if (pool->slot[k])
			*find_slot(slot, size, pool->slot[k]) = pool->slot[k];
	ts_free(pool->slot);
	pool->slot = slot;
	pool->size = size;
	return true;
}

const char *ts_pool_get(struct ts_pool *pool, const char *text)
{
	char **slot;

	if (2 * pool->used >= pool->size && !enlarge_pool(pool))
		return NULL;
	slot = find_slot(pool->slot, pool->size, text);
	if (!*slot) {
		*slot = ts_arena_strdup(&pool->arena, text);
		pool->used += *slot != NULL;
	}
	return *slot;
}

void ts_pool_free(struct ts_pool *pool)
{
	if (!pool)
		return;
	ts_arena_release(&pool->arena);
	ts_free(pool->slot);
	ts_free(pool);
}
