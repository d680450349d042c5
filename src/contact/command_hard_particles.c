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
		.summary = "allows a Young's modulus above 1e9 Pa",
		.doc = "In units si and cgs, the models of pair_style gran that use youngsModulus require it "
		       "to be between 5e6 and 1e9 Pa (5e7 and 1e10 in cgs). Harder particles need very small "
		       "time steps, and where overlaps stay small their motion is often the same. This "
		       "command removes the upper bound. Other units have no such bounds, nor have laws whose "
		       "stiffness is given.",
		.example = "hard_particles yes",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
