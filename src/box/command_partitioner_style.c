/* Command partitioner_style: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	struct ts_words words;
};

static const struct ts_arg args[] = {
	TS_REST("words", struct state, words, .help = "no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_partitioner_style)
const struct ts_command_style ts_command_partitioner_style = {
	.style = {
		.name = "partitioner_style",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "In LIGGGHTS this command sets how the box is divided among processes. tsim "
		       "distributes particles over threads.",
		.example = "partitioner_style zoltan OBJ_WEIGHT_DIM 1",
		.args = args,
		.state_size = sizeof(struct state),
	},
};
