/* Command soft_particles: allows Young's moduli below 5e6 Pa. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	bool on;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	(void)where;
	sim->soft_particles = ((const struct state *)state)->on;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_BOOL("on", struct state, on, .flags = TS_POSITIONAL,
		.help = "whether a Young's modulus below 5e6 Pa is accepted"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_soft_particles)
const struct ts_command_style ts_command_soft_particles = {
	.style = {
		.name = "soft_particles",
		.kind = TS_KIND_COMMAND,
		.summary = "allows a Young's modulus below 5e6 Pa",
		.doc = "In units si and cgs, the models of pair_style gran that use youngsModulus require it "
		       "to be between 5e6 and 1e9 Pa (5e7 and 1e10 in cgs). The overlaps of softer particles "
		       "are so large that the contact laws of spheres do not hold any more. This command "
		       "removes the lower bound. Other units have no such bounds, nor have laws whose "
		       "stiffness is given.",
		.example = "soft_particles yes",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
