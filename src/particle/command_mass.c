/* Command mass: sets the mass of particles by type. */
#include "core/sim.h"

#include "particle/columns.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	struct ts_types types;
	double mass;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_particles *p = sim->particles;
	int hi = s->types.hi ? s->types.hi : p->ntypes;

	TS_TRY(ts_particles_require_types(sim, "mass", &s->types, where));
	for (int t = s->types.lo; t <= hi; t++)
		p->type_mass[t] = s->mass;
	for (size_t i = 0; i < p->n; i++)
		if (p->type[i] >= s->types.lo && p->type[i] <= hi)
			p->mass[i] = s->mass;
	ts_particles_inverse_mass(p);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_TYPES("types", struct state, types, .flags = TS_POSITIONAL, .help = "particle types"),
	TS_REAL("mass", struct state, mass, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = "mass",
		.help = "mass of one particle"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_mass)
const struct ts_command_style ts_command_mass = {
	.style = {
		.name = "mass",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_ROWS,
		.summary = "Sets the mass of particles of a type",
		.doc = "Sets the mass of all present particles of these types, and of particles that\n"
		       "create_atoms creates later. `set` with the keyword density, diameter or mass\n"
		       "changes it afterwards.",
		.example = "mass 1 1.0\n"
		       "mass * 0.5",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
