/* Command region: defines or deletes a region. */
#include "core/life.h"

#include "core/uses.h"

#include "base/banned.h"

struct state {
	const char *id;
	struct ts_words rest;
};

static enum ts_status delete_region(struct tsim *sim, const char *id, const struct ts_place *where)
{
	const struct ts_word word = { .text = id, .place = *where };
	struct ts_instance *region;

	TS_TRY(ts_sim_require(sim, TS_KIND_REGION, &word, &region));
	return (ts_uses_region(sim, region) ? ts_sim_retire : ts_sim_destroy)(sim, TS_KIND_REGION, &word);
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	const struct ts_style *style;
	const struct ts_instance *old;

	if (ts_streq(s->rest.word[0].text, "delete"))
		return delete_region(sim, s->id, where);
	old = ts_sim_find(sim, TS_KIND_REGION, s->id);
	if (old)
		return ts_conflict(&sim->error, ts_sim_word(sim, 1, where),
				   "there is a region '%s' already (%s:%d)", s->id,
				   TS_FILE_AND_LINE(old->where));
	TS_TRY(ts_style_require(sim, TS_KIND_REGION, &s->rest.word[0], &style));
	return ts_sim_create(sim, TS_KIND_REGION, style, s->id, 0, ts_words_from(s->rest, 1),
			     &s->rest.word[0].place, NULL);
}

static const struct ts_arg args[] = {
	TS_WORD("id", struct state, id, .flags = TS_POSITIONAL, .help = "name of the region"),
	TS_REST("style", struct state, rest, .help = "style and its arguments, or delete"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_region)
const struct ts_command_style ts_command_region = {
	.style = {
		.name = "region",
		.kind = TS_KIND_COMMAND,
		.summary = "Defines a region of space",
		.doc = "Defines a region, a set of points to which other commands refer by its name; see\n"
		       "the pages of the region styles. `region ID delete` deletes it; commands that use\n"
		       "it must be deleted, too, before the next run.",
		.example = "region bed block 0 1 0 1 0 0.5 units box\n"
		       "region bed delete",
		.args = args,
		.ranks = TS_RANKS_FORMULAS,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
