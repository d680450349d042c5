/* Command unfix: deletes a fix. */
#include "core/life.h"

#include "base/banned.h"

struct state {
	const char *id;
};

static enum ts_status run_unfix(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct ts_word id = { .text = ((const struct state *)state)->id,
				    .place = *ts_sim_word(sim, 1, where) };

	return ts_sim_destroy(sim, TS_KIND_FIX, &id);
}

static const struct ts_arg args[] = {
	TS_WORD("id", struct state, id, .flags = TS_POSITIONAL, .help = "its name"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_unfix)
const struct ts_command_style ts_command_unfix = {
	.style = {
		.name = "unfix",
		.kind = TS_KIND_COMMAND,
		.summary = "Deletes a fix",
		.doc = "The fix and its data are deleted.",
		.example = "unfix fall",
		.args = args,
		.ranks = TS_RANKS_FORMULAS,
		.state_size = sizeof(struct state),
	},
	.run = run_unfix,
};
