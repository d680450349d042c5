/* Command fix_modify: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	struct ts_words rest;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_instance *inst;

	(void)where;
	return ts_sim_require(sim, TS_KIND_FIX, &s->rest.word[0], &inst);
}

static const struct ts_arg args[] = {
	TS_REST("id", struct state, rest,
		.help = "name of the fix, then energy yes|no, temp ID: no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_fix_modify)
const struct ts_command_style ts_command_fix_modify = {
	.style = {
		.name = "fix_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "The fix must exist.",
		.example = "fix_modify fall energy yes",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
