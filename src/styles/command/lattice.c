/* Command lattice: a lattice that create_atoms and regions refer to. */
#include "core/sim.h"

#include <math.h>

#include "particles/domain.h"
#include "particles/lattice.h"

#include "base/banned.h"

struct state {
	int style;
	double scale;
};

/* In lj units the scale is a reduced density: basis / (volume of the cell) = scale. */
static double constant(const struct tsim *sim, const struct state *s, const struct ts_lattice *l)
{
	double cell = l->cell[0] * l->cell[1] * (l->dimension == 3 ? l->cell[2] : 1);

	if (sim->units != TS_UNITS_LJ)
		return s->scale;
	return pow(l->nbasis / (s->scale * cell), 1.0 / l->dimension);
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	const struct ts_lattice *l = ts_lattice_get(s->style);
	double a = l ? constant(sim, s, l) : s->scale;

	if (l && l->dimension != sim->dimension)
		return ts_fail(&sim->error, TS_STATE, where,
			       "lattice %s has %d dimensions, the simulation has %d",
			       ts_lattice_names[s->style], l->dimension, sim->dimension);
	sim->domain->lattice = a;
	sim->domain->lattice_style = s->style;
	if (l)
		ts_log(&sim->log, "Lattice spacing in x,y,z = %g %g %g\n", a * l->cell[0],
		       a * l->cell[1], a * l->cell[2]);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_ENUM("style", struct state, style, ts_lattice_names, .flags = TS_POSITIONAL,
		.help = "kind of lattice"),
	TS_REAL("scale", struct state, scale, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.unit = "length", .help = "lattice constant; in lj units the reduced density"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_lattice)
const struct ts_command_style ts_command_lattice = {
	.style = {
		.name = "lattice",
		.kind = TS_KIND_COMMAND,
		.summary = "Defines a lattice",
		.doc = "Particles of create_atoms box and create_atoms region stand on its points. Regions and\n"
		       "positions given in lattice units (their default) are multiplied by the lattice constant.\n"
		       "The cells of hex and hcp have the edges a, sqrt(3) a and sqrt(8/3) a. With none there are\n"
		       "no points, but lengths are still multiplied. Without the command the constant is 1.",
		.example = "lattice sc 0.002\n"
		       "lattice none 1.0",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
