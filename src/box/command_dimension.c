/* Command dimension: two or three dimensions. */
#include "core/sim.h"

#include "box/domain.h"

#include "base/banned.h"

struct state {
	int64_t dimension;
};

static enum ts_status set_dimension(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	if (sim->has_box)
		return ts_fail(&sim->error, TS_STATE, where,
			       "dimension must come before the simulation box is created");
	sim->dimension = (int)s->dimension;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_INT("dimension", struct state, dimension, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 2,
	       .hi = 3, .help = "2 or 3"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_dimension)
const struct ts_command_style ts_command_dimension = {
	.style = {
		.name = "dimension",
		.kind = TS_KIND_COMMAND,
		.summary = "sets the number of dimensions",
		.doc = "In two dimensions particles are discs in the plane z = 0: their mass is density times "
		       "pi r^2, and fix nve/sphere uses the moment of inertia of discs by default. The box "
		       "must be periodic in z and contain the plane z = 0; the thermo keyword vol is its "
		       "area. The script must avoid forces and velocities out of the plane (fix enforce2d "
		       "removes them); a run warns if a particle is out of the plane or moves out of it.",
		.example = "dimension 2",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = set_dimension,
};
