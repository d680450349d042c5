/* Compute pair/gran/local/bond: bonds in the columns of pair/gran/local. */
#include <math.h>

#include "bond/bonds.h"
#include "contact/contact_columns.h"
#include "contact/contact_view.h"
#include "math/vec3.h"

#include "base/banned.h"

struct state {
	struct ts_contact_columns columns;
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->sim = sim;
	sim->bonds->shown = true;
	TS_TRY(ts_contact_columns_init(self, sim));
	if (s->columns.wanted[TS_CONTACT_HEAT])
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "heatFlux"),
			       "compute pair/gran/local/bond: no heat flows through bonds");
	return TS_OK;
}

static bool is_listed(const struct ts_instance *self, const struct tsim *sim, size_t b)
{
	const int32_t *row = sim->bonds->row[b];

	return ts_in_group(sim->particles, (size_t)row[0], self->group) &&
	       ts_in_group(sim->particles, (size_t)row[1], self->group);
}

static void collect_facts(const struct tsim *sim, size_t b, struct ts_contact_facts *f)
{
	const struct ts_particles *p = sim->particles;
	struct ts_contact_view v;
	double radius[2];

	ts_contact_view_of_bond(sim, b, &v);
	*f = (struct ts_contact_facts){ .id = { p->tag[v.a], p->tag[v.b], v.image } };
	radius[0] = p->radius[v.a];
	radius[1] = p->radius[v.b];
	for (int k = 0; k < 3; k++) {
		f->pos[k] = p->x[v.a][k];
		f->pos[3 + k] = p->x[v.b][k];
		f->vel[k] = p->v[v.a][k];
		f->vel[3 + k] = p->v[v.b][k];
		f->force[k] = v.force[k];
		f->torque[k] = sim->bonds->transmits ? sim->bonds->load[b].torque[0][k] : 0;
		f->n[k] = v.distance > 0 ? v.d[k] / v.distance : 0;
		f->point[k] = p->x[v.a][k] - v.d[k] * (radius[0] / (radius[0] + radius[1]));
	}
	f->delta = radius[0] + radius[1] - v.distance;
	f->area = fmax(ts_contact_area(radius[0], radius[1], v.distance), 0);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t width = ts_contact_columns_width(&s->columns, 0), n = 0;
	struct ts_contact_facts facts;

	TS_TRY(ts_contacts_require(s->sim, self));
	TS_TRY(ts_table_resize(out, sim->bonds->n, width));
	for (size_t b = 0; b < sim->bonds->n; b++) {
		if (!is_listed(self, sim, b))
			continue;
		collect_facts(sim, b, &facts);
		ts_contact_columns_write(&s->columns, 0, &facts, out->data + width * n++);
	}
	return ts_table_resize(out, n, width);
}

static const struct ts_value values[] = {
	{ "list", "", "a row for each bond", TS_LOCAL, 0, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REST_OPTIONAL("quantities", struct state, columns.words, .help = ts_contact_columns_help),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_pair_gran_local_bond)
const struct ts_style ts_compute_pair_gran_local_bond = {
	.name = "pair/gran/local/bond",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Forces, positions and other quantities of each bond",
	.doc = "A table with a row for each bond whose particles are both in the group, in the columns of "
	       "compute pair/gran/local. The particle with the smaller ID is the first. force is that of the "
	       "bond on it, without the contact force; torque the torque of the bond on it; delta and "
	       "contactArea are those of the two spheres (the area is 0 where they do not overlap); history "
	       "has no columns, as bonds have no history. Forces are those of the last force computation; "
	       "positions and velocities are the present ones. Stresses are columns of compute "
	       "bond/local.\n\n"
	       "With these columns `dump local/gran/vtk` shows bonds. The compute belongs to `cohesion bond` "
	       "of LIGGGHTS-INL, whose documentation does not list its columns; here they are those of "
	       "compute pair/gran/local, and it serves bonds of all styles.",
	.example = "compute c all pair/gran/local/bond\ndump d all local/gran/vtk 100 post/bonds*.vtk c",
	.args = args,
	.family = TS_FAMILY_CONTACTS,
	.state_size = sizeof(struct state),
	.values = values,
	.width = ts_contact_columns_known_width,
	.init = init,
};
