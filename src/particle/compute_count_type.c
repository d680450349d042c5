/* Compute count/type: number of particles or bonds of each type. */
#include "bond/bonds.h"
#include "particle/identity.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { ATOM, BOND };

struct state {
	int mode;
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->sim = sim;
	sim->run.needs_lists |= s->mode == BOND;
	sim->run.shows_lists |= s->mode == BOND;
	return TS_OK;
}

static void count_particles(const struct ts_instance *self, const struct ts_particles *p,
			    struct ts_table *out)
{
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			out->data[p->type[i] - 1] += 1;
}

/* Particles of bonds are looked up by tag: their local indices are valid only during a run. */
static enum ts_status count_bonds(const struct ts_instance *self, struct tsim *sim, struct ts_table *out)
{
	const struct ts_bonds *bonds = sim->bonds;
	const struct ts_particles *p = sim->particles;
	struct ts_identities map;

	TS_TRY(ts_identities(sim, false, &map));
	for (size_t b = 0; b < bonds->n; b++) {
		int32_t i = ts_identity_row(&map, bonds->tag[b][0]),
			j = ts_identity_row(&map, bonds->tag[b][1]);

		if (i >= 0 && j >= 0 && ts_in_group(p, (size_t)i, self->group) &&
		    ts_in_group(p, (size_t)j, self->group))
			out->data[bonds->type[b] - 1] += 1;
	}
	return TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t types = (size_t)(s->mode == BOND ? sim->bonds->ntypes : sim->particles->ntypes);

	TS_TRY(ts_table_resize(out, 1, types));
	for (size_t k = 0; k < types; k++)
		out->data[k] = 0;
	if (s->mode == BOND)
		return count_bonds(self, s->sim, out);
	count_particles(self, sim->particles, out);
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "counts", "", "number of each type, from type 1 on", TS_VECTOR, 0, NULL, eval },
	{ .name = NULL },
};

static const char *const modes[] = { [ATOM] = "atom", [BOND] = "bond", NULL };

static const struct ts_arg args[] = {
	TS_ENUM("mode", struct state, mode, modes, .flags = TS_POSITIONAL,
		.help = "whether particles or bonds are counted"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_count_type)
const struct ts_style ts_compute_count_type = {
	.name = "count/type",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Number of particles or bonds of each type",
	.doc = "c_ID[k] is the number of particles of type k in the group, or of bonds of type k with both "
	       "particles in the group.",
	.example = "compute kinds all count/type atom\ncompute left all count/type bond",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
