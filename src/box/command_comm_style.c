/* Command comm_style: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	int style;
};

static const char *const styles[] = { "brick", "tiled", NULL };

static const struct ts_arg args[] = {
	TS_ENUM("style", struct state, style, styles, .flags = TS_POSITIONAL, .help = "no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_comm_style)
const struct ts_command_style ts_command_comm_style = {
	.style = {
		.name = "comm_style",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "In LAMMPS this command sets how the box is divided among processes. In tsim `processors` "
		       "and `balance` do so; results do not depend on it.",
		.example = "comm_style tiled",
		.args = args,
		.state_size = sizeof(struct state),
	},
};
