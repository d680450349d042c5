/* Command atom_style: accepted for compatibility. */
#include "core/sim.h"

#include "particles/domain.h"

#include "base/banned.h"

struct state {
	int style;
	struct ts_words rest;
};

static const char *const styles[] = { "granular", "sphere", "hybrid", "bond/gran", "atomic", NULL };

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	(void)state;
	if (sim->domain->exists)
		return ts_fail(&sim->error, TS_STATE, where,
			       "atom_style must come before the simulation box is created");
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_ENUM("style", struct state, style, styles, .flags = TS_POSITIONAL,
		.help = "what particles are; no effect"),
	{ .name = "details",
	  .type = TS_ARG_REST,
	  .flags = TS_POSITIONAL | TS_OPTIONAL,
	  .offset = offsetof(struct state, rest),
	  .help = "further styles and their settings; no effect" },
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_atom_style)
const struct ts_command_style ts_command_atom_style = {
	.style = {
		.name = "atom_style",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "Particles are spheres with a radius, mass and velocity. Rotation, bonds and all else\n"
		       "exist as soon as something in the script needs them.",
		.example = "atom_style granular\n"
		       "atom_style hybrid granular bond/gran n_bondtypes 1 bonds_per_atom 6",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
