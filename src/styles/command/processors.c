/* Command processors: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	struct ts_words grid;
};

static const struct ts_arg args[] = {
	TS_REST("grid", struct state, grid, .help = "processes in x, y, z: no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_processors)
const struct ts_command_style ts_command_processors = {
	.style = {
		.name = "processors",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "Elsewhere it says how processes share the box.",
		.example = "processors 2 2 1",
		.args = args,
		.state_size = sizeof(struct state),
	},
};
