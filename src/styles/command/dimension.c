/* Command dimension: two or three dimensions. */
#include "core/sim.h"

#include "particles/domain.h"

#include "base/banned.h"

struct state {
	int64_t dimension;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	if (sim->domain->exists)
		return ts_fail(&sim->error, TS_STATE, where,
			       "dimension must come before the simulation box is created");
	sim->dimension = (int)s->dimension;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_INT("dimension", struct state, dimension, .flags = TS_POSITIONAL, .range = TS_WITHIN,
	       .lo = 2, .hi = 3, .help = "2 or 3"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_dimension)
const struct ts_command_style ts_command_dimension = {
	.style = {
		.name = "dimension",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets the number of dimensions",
		.doc = "In two dimensions particles are still spheres; keep them in the plane z = 0 with\n"
		       "initial velocities and forces that have no z component.",
		.example = "dimension 2",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
