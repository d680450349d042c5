/* Command modify_timing: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	struct ts_words words;
};

static const struct ts_arg args[] = {
	TS_REST("words", struct state, words, .help = "on, off or verbose: no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_modify_timing)
const struct ts_command_style ts_command_modify_timing = {
	.style = {
		.name = "modify_timing",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "In LIGGGHTS it chooses whether the time spent in each fix is measured.",
		.example = "modify_timing on",
		.args = args,
		.state_size = sizeof(struct state),
	},
};
