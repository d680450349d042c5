/* Command unfix: ends a fix. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	struct ts_words id;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	(void)where;
	if (s->id.n > 1)
		return ts_fail(&sim->error, TS_SYNTAX, &s->id.word[1].place,
			       "unfix: unexpected '%s', the line should end before it",
			       s->id.word[1].text);
	return ts_sim_destroy(sim, TS_KIND_FIX, &s->id.word[0]);
}

static const struct ts_arg args[] = {
	TS_REST("id", struct state, id, .help = "its name"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_unfix)
const struct ts_command_style ts_command_unfix = {
	.style = {
		.name = "unfix",
		.kind = TS_KIND_COMMAND,
		.summary = "Ends a fix",
		.doc = "It is removed with all that it holds.",
		.example = "unfix fall",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
