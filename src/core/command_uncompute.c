/* Command uncompute: deletes a compute. */
#include "core/life.h"

#include "base/banned.h"

struct state {
	const char *id;
};

static enum ts_status run_uncompute(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct ts_word id = { .text = ((const struct state *)state)->id,
				    .place = *ts_sim_word(sim, 1, where) };

	return ts_sim_destroy(sim, TS_KIND_COMPUTE, &id);
}

static const struct ts_arg args[] = {
	TS_WORD("id", struct state, id, .flags = TS_POSITIONAL, .help = "its name"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_uncompute)
const struct ts_command_style ts_command_uncompute = {
	.style = {
		.name = "uncompute",
		.kind = TS_KIND_COMMAND,
		.summary = "Deletes a compute",
		.doc = "The compute and its data are deleted.",
		.example = "uncompute energy",
		.args = args,
		.ranks = TS_RANKS_FORMULAS,
		.state_size = sizeof(struct state),
	},
	.run = run_uncompute,
};
