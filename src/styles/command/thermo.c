/* Command thermo: how often the table in the log gets a row. */
#include "core/sim.h"
#include "io/thermo.h"

#include "base/banned.h"

struct state {
	int64_t every;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	(void)where;
	sim->thermo->every = s->every;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_INT("every", struct state, every, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
	       .help = "steps between rows; 0: only the first and the last step of a run"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_thermo)
const struct ts_command_style ts_command_thermo = {
	.style = {
		.name = "thermo",
		.kind = TS_KIND_COMMAND,
		.summary = "How often the table in the log gets a row",
		.doc = "A row is written at the first and the last step of each run and when the step is a multiple of\n"
		       "N. Default 0.",
		.example = "thermo 1000",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
