/* Command hard_particles: allows Young's moduli above 1e9 Pa. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	bool on;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	(void)where;
	sim->hard_particles = ((const struct state *)state)->on;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_BOOL("on", struct state, on, .flags = TS_POSITIONAL,
		.help = "whether a Young's modulus above 1e9 Pa is accepted"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_hard_particles)
const struct ts_command_style ts_command_hard_particles = {
	.style = {
		.name = "hard_particles",
		.kind = TS_KIND_COMMAND,
		.summary = "lets Young's modulus be above 1e9 Pa",
		.doc = "With units si and cgs, the models of pair_style gran that need youngsModulus want it "
		       "from 5e6\n"
		       "to 1e9 Pa (5e7 to 1e10 in cgs). Harder particles need very small time steps, and "
		       "where\n"
		       "overlaps stay small they often behave no differently.\n"
		       "Other units have no such limit, nor have laws whose stiffness is given.",
		.example = "hard_particles yes",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
