/* Command suffix: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	struct ts_words words;
};

static const struct ts_arg args[] = {
	TS_REST("words", struct state, words, .help = "no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_suffix)
const struct ts_command_style ts_command_suffix = {
	.style = {
		.name = "suffix",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "In LAMMPS this command selects variants of styles for accelerators. In tsim all styles use threads, "
		       "see -threads.",
		.example = "suffix off\nsuffix omp",
		.args = args,
		.state_size = sizeof(struct state),
	},
};
