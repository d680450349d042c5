/* Command compute: makes a compute. */
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

	(void)where;
	TS_TRY(ts_style_require(sim, TS_KIND_COMPUTE, &s->rest.word[0], &style));
	return ts_sim_create(sim, TS_KIND_COMPUTE, style, s->id, s->group,
			     ts_words_from(s->rest, 1), &s->rest.word[0].place, NULL);
}

static const struct ts_arg args[] = {
	TS_WORD("id", struct state, id, .flags = TS_POSITIONAL, .help = "its name"),
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL,
		 .help = "particles it looks at"),
	TS_REST("style", struct state, rest, .help = "style and its arguments"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_compute)
const struct ts_command_style ts_command_compute = {
	.style = {
		.name = "compute",
		.kind = TS_KIND_COMMAND,
		.summary = "Defines a quantity computed from particles",
		.doc = "It is evaluated when something asks for it by the name c_ID. See the pages of the compute\n"
		       "styles.",
		.example = "compute energy all ke",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
