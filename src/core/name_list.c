#include "core/name_list.h"

#include <string.h>

#include "core/unsupported_names.h"

#include "base/banned.h"

/* By memcpy, since the rows of the table may be structs of any type. */
static const char *name_at(const void *table, size_t stride, int k)
{
	const char *name;

	memcpy(&name, (const char *)table + (size_t)k * stride, sizeof name);
	return name;
}

/* `noun`: what the names of the table are. */
static enum ts_status fail_unknown_name(struct tsim *sim, const char *what, const char *noun,
					const struct ts_word *word, const void *table, size_t stride)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);
	const char *remark = ts_unsupported_word_remark(what, word->text);

	if (remark)
		return ts_fail(&sim->error, TS_UNKNOWN, &word->place,
			       "%s: %s '%s' is known, but tsim does not have it: %s", what, noun, word->text,
			       remark);
	for (int k = 0; name_at(table, stride, k); k++)
		ts_suggest_try(&suggest, name_at(table, stride, k));
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place, "%s: unknown %s '%s'%s", what, noun, word->text,
		       ts_suggest_text(&suggest));
}

enum ts_status ts_name_list_room(struct tsim *sim, struct ts_arena *arena, size_t n, struct ts_name_list *out)
{
	if (!out->item)
		out->item = ts_arena_alloc(arena, n ? n : 1, sizeof *out->item);
	out->n = 0;
	return out->item ? TS_OK : ts_nomem(&sim->error);
}

/* The index of the word in the table; -1: it is not there. */
static int find_name(const struct ts_word *word, const void *table, size_t stride)
{
	const char *name;

	for (int k = 0; (name = name_at(table, stride, k)); k++)
		if (ts_streq(name, word->text))
			return k;
	return -1;
}

enum ts_status ts_name_list_find(struct tsim *sim, const char *what, const struct ts_word *word,
				 const void *table, size_t stride, int *index)
{
	*index = find_name(word, table, stride);
	return *index >= 0 ? TS_OK : fail_unknown_name(sim, what, "quantity", word, table, stride);
}

enum ts_status ts_name_list_check_keywords(struct tsim *sim, const char *what, struct ts_words words,
					   const char *const *names)
{
	for (size_t k = 0; k < words.n; k++)
		if (find_name(&words.word[k], names, sizeof *names) < 0)
			return fail_unknown_name(sim, what, "keyword", &words.word[k], names, sizeof *names);
	return TS_OK;
}

enum ts_status ts_name_list_read(struct tsim *sim, const char *what, struct ts_arena *arena,
				 struct ts_words words, const void *table, size_t stride,
				 struct ts_name_list *out)
{
	TS_TRY(ts_name_list_room(sim, arena, words.n, out));
	for (; out->n < words.n; out->n++)
		TS_TRY(ts_name_list_find(sim, what, &words.word[out->n], table, stride, &out->item[out->n]));
	return TS_OK;
}
