/* Command balance: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	double threshold;
	struct ts_words rest;
};

static const struct ts_arg args[] = {
	TS_REAL("threshold", struct state, threshold, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.help = "no effect"),
	TS_REST_OPTIONAL("how", struct state, rest, .help = "no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_balance)
const struct ts_command_style ts_command_balance = {
	.style = {
		.name = "balance",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "In LAMMPS this command adjusts the sub-domains of processes. tsim distributes the "
		       "particles evenly over its threads.",
		.example = "balance 1.1 shift xy 10 1.05",
		.args = args,
		.state_size = sizeof(struct state),
	},
};
