#include "image/image_groups.h"

#include <stdio.h>

#include "base/banned.h"

static size_t count(struct ts_words words, const char *name)
{
	size_t n = 0;

	for (size_t k = 0; k < words.n; k++)
		n += ts_streq(words.word[k].text, name);
	return n;
}

enum ts_status ts_image_read_groups(struct ts_instance *self, struct tsim *sim, const char *name,
				    const struct ts_arg *rows, struct ts_words words, size_t size,
				    void **array, size_t *n)
{
	const size_t most = count(words, name);
	char what[64];
	size_t k;

	if (most && !*array)
		*array = ts_arena_alloc(&self->arena, most, size);
	if (most && !*array)
		return ts_nomem(&sim->error);
	snprintf(what, sizeof what, "dump image: %s", name);
	for (k = 0; words.n; k++) {
		struct ts_image_group *group = (void *)((char *)*array + k * size);
		size_t used = 1;

		while (used < words.n && !ts_streq(words.word[used].text, name))
			used++;
		group->keyword = words.word[0];
		group->words = (struct ts_words){ words.word + 1, used - 1 };
		TS_TRY(ts_args_parse(sim, what, rows, group->words, &group->keyword.place, &self->arena,
				     group));
		words = ts_words_from(words, used);
	}
	*n = k;
	return TS_OK;
}

const struct ts_place *ts_image_group_word(const struct ts_image_group *group, const char *text)
{
	for (size_t k = 0; text && k < group->words.n; k++)
		if (ts_streq(group->words.word[k].text, text))
			return &group->words.word[k].place;
	return &group->keyword.place;
}

enum ts_status ts_image_group_colour(struct ts_instance *self, struct tsim *sim,
				     const struct ts_image_group *group, const char *name,
				     struct ts_colour *out)
{
	const struct ts_word word = { .text = name, .place = *ts_image_group_word(group, name) };

	return ts_image_find_colour(sim, self->state, &word, out);
}
