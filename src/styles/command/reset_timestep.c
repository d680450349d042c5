/* Command reset_timestep: sets the step counter. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	int64_t step;
	double time;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	(void)where;
	sim->clock.step = sim->clock.base_step = s->step;
	sim->clock.base_time = isnan(s->time) ? (double)s->step * sim->clock.dt : s->time;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_INT("step", struct state, step, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
	       .help = "new value of the step counter"),
	TS_REAL("time", struct state, time, .flags = TS_OPTIONAL, .unit = "time",
		.help = "new simulated time; without it step times dt"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_reset_timestep)
const struct ts_command_style ts_command_reset_timestep = {
	.style = {
		.name = "reset_timestep",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets the step counter",
		.doc = "The simulated time becomes step times dt unless it is given.",
		.example = "reset_timestep 0",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
