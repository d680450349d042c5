#include "core/name_list.h"

#include <string.h>

#include "base/banned.h"

/* Copied out, as the rows of the table may be of any type. */
static const char *name_at(const void *table, size_t stride, int k)
{
	const char *name;

	memcpy(&name, (const char *)table + (size_t)k * stride, sizeof name);
	return name;
}

static enum ts_status unknown(struct tsim *sim, const char *what, const struct ts_word *word,
			      const void *table, size_t stride)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);

	for (int k = 0; name_at(table, stride, k); k++)
		ts_suggest_try(&suggest, name_at(table, stride, k));
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place, "%s: unknown quantity '%s'%s", what,
		       word->text, ts_suggest_text(&suggest));
}

enum ts_status ts_name_list_read(struct tsim *sim, const char *what, struct ts_arena *arena,
				 struct ts_words words, const void *table, size_t stride,
				 struct ts_name_list *out)
{
	if (!out->item)
		out->item = ts_arena_alloc(arena, words.n ? words.n : 1, sizeof *out->item);
	if (!out->item)
		return ts_nomem(&sim->error);
	for (out->n = 0; out->n < words.n; out->n++) {
		const struct ts_word *word = &words.word[out->n];
		const char *name;
		int k = 0;

		while ((name = name_at(table, stride, k)) && !ts_streq(name, word->text))
			k++;
		if (!name)
			return unknown(sim, what, word, table, stride);
		out->item[out->n] = k;
	}
	return TS_OK;
}
