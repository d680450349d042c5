/* Command pair_modify: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	int shift, tail, mix;
};

static const char *const switches[] = { "no", "yes", NULL };
static const char *const mixings[] = { "geometric", "arithmetic", "sixthpower", NULL };

static const struct ts_arg args[] = {
	TS_ENUM("shift", struct state, shift, switches, .fallback = "no",
		.help = "no effect: contact forces end where the surfaces separate"),
	TS_ENUM("tail", struct state, tail, switches, .fallback = "no", .help = "no effect"),
	TS_ENUM("mix", struct state, mix, mixings, .fallback = "geometric",
		.help = "no effect: the pair style defines how coefficients are mixed"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_pair_modify)
const struct ts_command_style ts_command_pair_modify = {
	.style = {
		.name = "pair_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "In LAMMPS it changes long-range potentials; contact laws have none.",
		.example = "pair_modify shift yes",
		.args = args,
		.state_size = sizeof(struct state),
	},
};
