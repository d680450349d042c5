#include "base/words.h"

#include <string.h>

#include "base/banned.h"

enum ts_status ts_words_copy(struct ts_arena *arena, struct ts_words from, struct ts_words *to)
{
	struct ts_word *word = ts_arena_alloc(arena, from.n, sizeof *word);

	if (!word)
		return TS_NOMEM;
	for (size_t k = 0; k < from.n; k++) {
		word[k] = from.word[k];
		word[k].text = ts_arena_strdup(arena, from.word[k].text);
		if (!word[k].text)
			return TS_NOMEM;
	}
	*to = (struct ts_words){ word, from.n };
	return TS_OK;
}

enum ts_status ts_words_append(struct ts_arena *arena, struct ts_words from, struct ts_words *to)
{
	struct ts_word *word = ts_arena_alloc(arena, to->n + from.n, sizeof *word);
	struct ts_words added;

	if (!word)
		return TS_NOMEM;
	TS_TRY(ts_words_copy(arena, from, &added));
	for (size_t k = 0; k < to->n; k++)
		word[k] = to->word[k];
	for (size_t k = 0; k < from.n; k++)
		word[to->n + k] = added.word[k];
	*to = (struct ts_words){ word, to->n + from.n };
	return TS_OK;
}

static size_t next_word(const char *line, size_t at, size_t *length)
{
	at += strspn(line + at, " \t\r\n");
	*length = line[at] == '#' ? 0 : strcspn(line + at, " \t\r\n#");
	return at;
}

enum ts_status ts_words_join(struct ts_arena *arena, struct ts_words a, struct ts_words b,
			     struct ts_words *out)
{
	struct ts_word *word;

	*out = a.n ? a : b;
	if (!a.n || !b.n)
		return TS_OK;
	word = ts_arena_alloc(arena, a.n + b.n, sizeof *word);
	if (!word)
		return TS_NOMEM;
	for (size_t k = 0; k < a.n + b.n; k++)
		word[k] = k < a.n ? a.word[k] : b.word[k - a.n];
	*out = (struct ts_words){ word, a.n + b.n };
	return TS_OK;
}

enum ts_status ts_words_split(struct ts_arena *arena, const char *line, const struct ts_place *place,
			      struct ts_words *out)
{
	size_t n = 0, length;
	struct ts_word *word;
	char *copy = ts_arena_strdup(arena, line);

	for (size_t at = next_word(line, 0, &length); length; at = next_word(line, at + length, &length))
		n++;
	word = ts_arena_alloc(arena, n, sizeof *word);
	if (!copy || !word)
		return TS_NOMEM;
	n = 0;
	for (size_t at = next_word(line, 0, &length); length; at = next_word(line, at + length, &length)) {
		word[n].text = copy + at;
		word[n].place = *place;
		word[n].place.column = (int)at + 1;
		word[n++].place.length = (int)length;
		copy[at + length] = '\0';
	}
	*out = (struct ts_words){ word, n };
	return TS_OK;
}
