#include "core/sim.h"

#include "base/banned.h"

struct style_line {
	struct ts_words words;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct style_line *line = state;

	return ts_sim_choose(sim, TS_KIND_FLOW, line->words, where);
}

static const struct ts_arg args[] = {
	TS_REST("style", struct style_line, words, .help = "a flow style and its arguments"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_flow_style)
const struct ts_command_style ts_command_flow_style = {
	.style = { .name = "flow_style",
		   .kind = TS_KIND_COMMAND,
		   .summary = "chooses the fluid around the particles",
		   .doc = "Replaces the flow style there was. Without one there is no fluid and drag "
			  "fixes are refused.",
		   .example = "flow_style uniform velocity 0 0 1.0 viscosity 1.0e-3",
		   .args = args,
		   .state_size = sizeof(struct style_line) },
	.run = run,
};
