/* Command hard_particles: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	bool on;
};

static const struct ts_arg args[] = {
	TS_BOOL("on", struct state, on, .flags = TS_POSITIONAL, .help = "no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_hard_particles)
const struct ts_command_style ts_command_hard_particles = {
	.style = {
		.name = "hard_particles",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "In LIGGGHTS it lifts a limit of Young's modulus. Here there is none: any modulus will do,\n"
		       "as long as the time step resolves the contacts.",
		.example = "hard_particles yes",
		.args = args,
		.state_size = sizeof(struct state),
	},
};
