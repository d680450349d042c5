/* Command timer: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	struct ts_words words;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	(void)sim, (void)state, (void)where;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REST("words", struct state, words, .help = "no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_timer)
const struct ts_command_style ts_command_timer = {
	.style = {
		.name = "timer",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "The times spent in each stage are always taken and shown after a run; to stop after some\n"
		       "wall time, see fix halt.",
		.example = "timer full",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
