/* Command timer: lets runs go on after fix halt, else accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	struct ts_words words;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	(void)where;
	for (size_t k = 0; k < s->words.n; k++)
		if (ts_streq(s->words.word[k].text, "timeout"))
			sim->halted = false;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REST("words", struct state, words, .help = "timeout reset: run again after fix halt; all others: no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_timer)
const struct ts_command_style ts_command_timer = {
	.style = {
		.name = "timer",
		.kind = TS_KIND_COMMAND,
		.summary = "Lets runs go on after fix halt, else has no effect",
		.doc = "The times spent in each stage are always taken and shown after a run; to stop after some\n"
		       "wall time, see fix halt.",
		.example = "timer full\ntimer timeout reset",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
