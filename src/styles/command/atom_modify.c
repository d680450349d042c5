/* Command atom_modify: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	struct ts_words rest;
};

static const struct ts_arg args[] = {
	TS_REST("settings", struct state, rest,
		.help = "map array|hash, sort every size: no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_atom_modify)
const struct ts_command_style ts_command_atom_modify = {
	.style = {
		.name = "atom_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "Elsewhere it says how particles are found by identity and when they are sorted. Here both\n"
		       "are settled, and results do not depend on them.",
		.example = "atom_modify map array sort 0 0",
		.args = args,
		.state_size = sizeof(struct state),
	},
};
