/* Command units: the system of units and the default time step. */
#include "core/sim.h"
#include "core/units.h"

#include "box/domain.h"
#include "thermo/thermo.h"

#include "base/banned.h"

struct state {
	int units;
};

/* In the order of enum ts_units. */
static const char *const names[] = { "lj", "si", "cgs", "micro", "real", "metal", "electron", "nano", NULL };

static enum ts_status set_units(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	if (sim->has_box)
		return ts_fail(&sim->error, TS_STATE, where,
			       "units must come before the simulation box is created");
	if (s->units > TS_UNITS_MICRO)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "units %s are for atoms: use si, cgs, micro or lj", names[s->units]);
	sim->units = (enum ts_units)s->units;
	sim->units_given = true;
	sim->thermo->norm = sim->thermo->norm_default = s->units == TS_UNITS_LJ;
	ts_sim_set_dt(sim, ts_units_dt(sim->units));
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_ENUM("system", struct state, units, names, .flags = TS_POSITIONAL, .help = "system of units"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_units)
const struct ts_command_style ts_command_units = {
	.style = {
		.name = "units",
		.kind = TS_KIND_COMMAND,
		.summary = "sets the system of units",
		.doc = "All input and output is in the given system of units; tsim converts nothing. The "
		       "command also sets the default time step: lj 0.005, si 1e-8 s, cgs 1e-8 s, micro 2 "
		       "microseconds. Default: lj. If `units lj` is given, energies in the thermo output are "
		       "divided by the number of particles (see thermo_modify norm). real, metal, electron "
		       "and nano are for atoms and are refused.",
		.example = "units si",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = set_units,
};
