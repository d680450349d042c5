/* Compute group/group: force between two groups. */
#include "bond/bonds.h"
#include "contact/contact_view.h"
#include "math/exactsum.h"

#include "base/banned.h"

struct state {
	int other;
	bool pair, bond, kspace;
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	sim->neigh->keep_forces = true;
	((struct state *)self->state)->sim = sim;
	return TS_OK;
}

/* Adds the force on the group: factor +1 where a is in it and b in the other, -1 in the opposite case, 0 if
 * both hold. */
static void add_force(const struct ts_instance *self, const struct tsim *sim,
		      const struct ts_contact_view *view, struct ts_exactsum sum[3])
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	int sign = (ts_in_group(p, view->a, self->group) && ts_in_group(p, view->b, s->other)) -
		   (ts_in_group(p, view->b, self->group) && ts_in_group(p, view->a, s->other));

	for (int k = 0; sign && k < 3; k++)
		ts_exactsum_add(&sum[k], sign * view->force[k]);
}

/* Whether one particle is in the group and the other in the other group: few pairs are, the others need no view. */
static bool concerns(const struct ts_instance *self, const struct ts_particles *p, size_t i, size_t j)
{
	const struct state *s = self->state;

	j = j < p->n ? j : (size_t)p->ghost_owner[j - p->n];
	return (ts_in_group(p, i, self->group) && ts_in_group(p, j, s->other)) ||
	       (ts_in_group(p, j, self->group) && ts_in_group(p, i, s->other));
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	const struct ts_contact_list *list = &sim->neigh->contacts;
	struct ts_exactsum sum[3];
	struct ts_contact_view view;

	TS_TRY(ts_contacts_forces(s->sim, self));
	for (int k = 0; k < 3; k++)
		sum[k] = ts_exactsum_start();
	for (size_t r = 0; s->pair && r < list->n; r++) {
		if (!ts_contact_touches(list, r) ||
		    !concerns(self, sim->particles, (size_t)list->i[r], (size_t)list->j[r]) ||
		    !ts_contact_counts(sim, r, 0))
			continue;
		ts_contact_view(sim, r, &view);
		add_force(self, sim, &view, sum);
	}
	for (size_t b = 0; s->bond && b < sim->bonds->n; b++) {
		const int32_t *row = sim->bonds->row[b];

		if (!concerns(self, sim->particles, (size_t)row[0], (size_t)row[1]))
			continue;
		ts_contact_view_of_bond(sim, b, &view);
		add_force(self, sim, &view, sum);
	}
	for (int k = 0; k < 3; k++)
		out->data[k] = ts_exactsum_value(&sum[k]);
	return TS_OK;
}

static const char *const names[] = { "fx", "fy", "fz", NULL };
static const struct ts_value values[] = {
	{ "force", "force", "force on the group, by the other group", TS_VECTOR, 3, names, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_GROUP("other", struct state, other, .flags = TS_POSITIONAL, .help = "the other group"),
	TS_BOOL("pair", struct state, pair, .fallback = "yes", .help = "whether contact forces are included"),
	TS_BOOL("bond", struct state, bond, .fallback = "no", .help = "whether bond forces are included"),
	TS_BOOL("kspace", struct state, kspace, .fallback = "no",
		.help = "no effect: there are no long-range forces"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_group_group)
const struct ts_style ts_compute_group_group = {
	.name = "group/group",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Force between two groups",
	.doc = "The sum of the forces that particles of the other group exert on those of the compute's "
	       "group through contacts, and with `bond yes` also through bonds. A pair whose particles are "
	       "each in both groups counts once in each direction and so adds nothing. The sum is rounded "
	       "once. The output is the force only, no energy.",
	.example = "compute push upper group/group lower",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
