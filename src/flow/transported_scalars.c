#include "flow/transported_scalars.h"

#include <string.h>

#include "flow/flow.h"

#include "base/banned.h"

static bool transports_scalar(const struct ts_instance *inst)
{
	const char *family = inst->style->family;

	return family && ts_streq(family, TS_FAMILY_FLOW_PART) &&
	       ((const struct ts_flow_part *)inst->state)->scalar;
}

static bool is_fix(const struct ts_word *word)
{
	return strncmp(word->text, "f_", 2) == 0;
}

enum ts_status ts_flow_scalar_field(struct tsim *sim, const char *what, const struct ts_word *word,
				    struct ts_flow_scalar *out)
{
	const struct ts_flow_part *part;
	const struct ts_word id = { .text = word->text + 2, .place = word->place };
	struct ts_instance *fix;

	TS_TRY(ts_sim_require(sim, TS_KIND_FIX, &id, &fix));
	if (!transports_scalar(fix))
		return ts_fail(&sim->error, TS_STATE, &word->place,
			       "%s: fix %s (style %s) transports no scalar", what, fix->id, fix->style->name);
	ts_flow_complete(sim);
	part = fix->state;
	out->value = part->scalar(fix);
	for (int face = 0; face < 6; face++)
		out->given[face / 2][face % 2] =
			part->scalar_given && part->scalar_given(fix, face / 2, face % 2);
	return TS_OK;
}

enum ts_status ts_flow_read_names(struct tsim *sim, const char *what, struct ts_arena *arena,
				  struct ts_words words, const void *table, size_t stride,
				  struct ts_name_list *out)
{
	TS_TRY(ts_name_list_room(sim, arena, words.n, out));
	for (; out->n < words.n; out->n++) {
		const struct ts_word *word = &words.word[out->n];
		struct ts_flow_scalar field;

		if (is_fix(word)) {
			TS_TRY(ts_flow_scalar_field(sim, what, word, &field));
			out->item[out->n] = TS_FLOW_SCALAR;
		} else {
			TS_TRY(ts_name_list_find(sim, what, word, table, stride, &out->item[out->n]));
		}
	}
	return TS_OK;
}

struct ts_instance *ts_flow_next_scalar(const struct tsim *sim, size_t *k)
{
	struct ts_instance *part;

	while ((part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, k)))
		if (transports_scalar(part))
			return part;
	return NULL;
}
