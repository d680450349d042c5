/* Compute: number of bonds of each particle. */
#include "bond/bonds.h"
#include "particle/identity.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	int64_t type;
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	((struct state *)self->state)->sim = sim;
	return TS_OK;
}

static enum ts_status count_bonds(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	const struct ts_bonds *bonds = sim->bonds;
	struct ts_identities map;

	TS_TRY(ts_table_resize(out, p->n, 1));
	TS_TRY(ts_identities(s->sim, false, &map));
	for (size_t i = 0; i < p->n; i++)
		out->data[i] = 0;
	for (size_t b = 0; b < bonds->n; b++) {
		for (int side = 0; side < 2; side++) {
			int32_t i = ts_identity_row(&map, bonds->tag[b][side]);

			if (i >= 0 && ts_in_group(p, (size_t)i, self->group) &&
			    (s->type == INT64_MIN || bonds->type[b] == s->type))
				out->data[i] += 1;
		}
	}
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "bonds", "", "number of bonds; 0 outside the group", TS_PERATOM, 1, NULL, count_bonds },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_INT("bond/type", struct state, type, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
	       .help = "count only bonds of this type"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_nbond_atom)
const struct ts_style ts_compute_nbond_atom = {
	.name = "nbond/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "number of bonds of each particle",
	.doc = "Counts the unbroken bonds of each particle of the group, those to partners outside the group "
	       "included. Particles outside the group have 0.",
	.example = "compute held rock nbond/atom\ncompute two rock nbond/atom bond/type 2",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
