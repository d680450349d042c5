/* Command communicate: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	int mode;
	bool velocity;
	double cutoff;
	int group;
};

static const char *const modes[] = { "single", "multi", NULL };

static const struct ts_arg args[] = {
	TS_ENUM("mode", struct state, mode, modes, .flags = TS_POSITIONAL, .help = "no effect"),
	TS_BOOL("vel", struct state, velocity, .fallback = "yes", .help = "no effect"),
	TS_REAL("cutoff", struct state, cutoff, .fallback = "0", .range = TS_NOT_NEGATIVE,
		.unit = "length", .help = "no effect"),
	TS_GROUP("group", struct state, group, .fallback = "all", .help = "no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_communicate)
const struct ts_command_style ts_command_communicate = {
	.style = {
		.name = "communicate",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "Elsewhere it says how processes exchange ghost particles. Here ghosts always carry\n"
		       "velocities and reach as far as the contacts need.",
		.example = "communicate single vel yes",
		.args = args,
		.state_size = sizeof(struct state),
	},
};
