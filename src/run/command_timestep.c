/* Command timestep: sets the time step. */
#include "core/sim.h"

#include <math.h>

#include "base/banned.h"

struct state {
	double dt;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	if (s->dt * s->dt == 0 || isinf(s->dt * s->dt)) /* integrators and limits need dt^2 */
		return ts_fail(&sim->error, TS_RANGE, where,
			       "timestep: %g has no square, expected 1e-150 to 1e150", s->dt);
	ts_sim_set_dt(sim, s->dt);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REAL("dt", struct state, dt, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = "time",
		.help = "time step"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_timestep)
const struct ts_command_style ts_command_timestep = {
	.style = {
		.name = "timestep",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets the time step",
		.doc = "Sets the time step of the integration. Each run compares it with the stability limits "
		       "of all styles; -explain prints them.",
		.example = "timestep 1e-5",
		.args = args,
		.ranks = TS_RANKS_FORMULAS,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
