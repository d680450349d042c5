/* Command fix: makes a fix. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	const char *id;
	int group;
	struct ts_words rest;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	const struct ts_style *style;

	TS_TRY(ts_style_require(sim, TS_KIND_FIX, &s->rest.word[0], &style));
	if (!style->boxless && !ts_sim_has_box(sim))
		return ts_fail(&sim->error, TS_STATE, where,
			       "fix %s needs a simulation box: use create_box or read_restart first",
			       style->name);
	return ts_sim_create(sim, TS_KIND_FIX, style, s->id, s->group, ts_words_from(s->rest, 1),
			     &s->rest.word[0].place, NULL);
}

static const struct ts_arg args[] = {
	TS_WORD("id", struct state, id, .flags = TS_POSITIONAL, .help = "its name"),
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL,
		 .help = "particles it acts on"),
	TS_REST("style", struct state, rest, .help = "style and its arguments"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_fix)
const struct ts_command_style ts_command_fix = {
	.style = {
		.name = "fix",
		.kind = TS_KIND_COMMAND,
		.summary = "Makes something act on particles during runs",
		.doc = "Fixes act in the order in which they are made. An id in use by the same style is replaced\n"
		       "in its place. See the pages of the fix styles.",
		.example = "fix fall all gravity 9.81 vector 0 0 -1",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
