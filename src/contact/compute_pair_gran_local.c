/* Compute pair/gran/local: contacts in the columns of LIGGGHTS. */
#include "contact/contact_columns.h"
#include "contact/contact_loop.h"
#include "contact/contact_view.h"
#include "heat/heat.h"
#include "math/vec3.h"
#include "neigh/contact_memory.h"

#include "base/banned.h"

struct state {
	struct ts_contact_columns columns;
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->sim = sim;
	sim->neigh->keep_forces = true;
	TS_TRY(ts_contact_columns_init(self, sim));
	if (s->columns.wanted[TS_CONTACT_HEAT] && !ts_heat_of(sim))
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "heatFlux"),
			       "compute pair/gran/local: no heat flows without a fix heat/gran");
	return TS_OK;
}

/* The tangential force exerts a torque of the same direction on both particles, each with its own lever arm; that of rolling
 * friction is opposite. */
static void add_torque(const struct tsim *sim, const struct ts_contact_view *v, struct ts_contact_facts *f)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	size_t slot = ts_contact_kept(list, v->row);

	for (int k = 0; list->parts > 1 && k < 3; k++) {
		f->torque[k] = (sim->particles->radius[v->a] - ts_contact_force(list, slot)[3]) *
			       ts_contact_tangential_torque(list, slot)[k];
		if (list->parts > 2)
			f->torque[k] += v->sign * ts_contact_rolling_torque(list, slot)[k];
	}
}

/* Conductance of the last step times the present temperature difference. */
static double heat_of_contact(const struct tsim *sim, const struct ts_contact_view *v)
{
	const struct ts_heat *heat = ts_heat_of(sim);
	const struct ts_heat_pairs *pairs = &heat->pairs[0];
	const double *temperature = ts_heat_column(sim, heat->temperature);

	if (!heat->ready || pairs->rows != &sim->neigh->contacts || v->row >= pairs->capacity)
		return 0;
	return pairs->conductance[v->row] * (temperature[v->b] - temperature[v->a]);
}

/* With `legacy`: recomputes the force with the velocities at the end of the step, as LIGGGHTS outputs it.
 * Ghosts only have velocities of the half step, so contacts with them keep the force that acted. */
static void recompute_force(const struct tsim *sim, const struct ts_contact_view *v,
			    struct ts_contact_facts *f)
{
	const struct ts_pair *pair = ts_sim_only(sim, TS_KIND_PAIR)->state;
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;
	size_t i = (size_t)list->i[v->row], j = (size_t)list->j[v->row];
	const struct ts_granular_model *model = ts_pair_model(pair, p->type[i], p->type[j]);
	double memory[TS_GRANULAR_MEMORY + 1] = { 0 };
	struct ts_granular_force acting;
	struct ts_touch t;

	for (size_t k = 0; k < list->history_width; k++)
		memory[k] = ts_contact_history(list, v->row)[k];
	ts_contact_touch(p, i, j, model, &t);
	ts_granular_add_bulge(model, memory, &t);
	ts_granular_contact(model, ts_pair_law(pair, p->type[i], p->type[j]), &t, sim->clock.dt, false,
			    memory, &acting);
	for (int k = 0; k < 3; k++) {
		f->force[k] = v->sign * acting.force[k];
		if (list->parts > 1)
			f->torque[k] =
				(p->radius[v->a] - ts_granular_arm_reduction(model, &t)) * acting.turn[k] +
				v->sign * acting.roll[k];
	}
}

/* Quantities of contact r. The contact point divides the line of centres in the ratio of the radii. */
static void collect_facts(const struct tsim *sim, size_t r, const bool *wanted, struct ts_contact_facts *f)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_contact_list *list = &sim->neigh->contacts;
	struct ts_contact_view v;
	double a, b;

	ts_contact_view(sim, r, &v);
	*f = (struct ts_contact_facts){ .id = { p->tag[v.a], p->tag[v.b], v.image } };
	a = p->radius[v.a];
	b = p->radius[v.b];
	for (int k = 0; k < 3; k++) {
		f->pos[k] = p->x[v.a][k];
		f->pos[3 + k] = p->x[v.b][k];
		f->vel[k] = p->v[v.a][k];
		f->vel[3 + k] = p->v[v.b][k];
		f->force[k] = v.force[k];
		f->n[k] = v.distance > 0 ? v.d[k] / v.distance : 0;
		f->point[k] = p->x[v.a][k] - v.d[k] * (a / (a + b));
	}
	for (size_t k = 0; k < list->history_width; k++)
		f->history[k] = ts_contact_history(list, r)[k] * (v.sign < 0 ? list->history_sign[k] : 1);
	f->area = ts_contact_area(a, b, v.distance);
	f->delta = a + b - v.distance;
	add_torque(sim, &v, f);
	if (wanted[TS_CONTACT_HEAT])
		f->heat = heat_of_contact(sim, &v);
	if (sim->legacy == TS_LEGACY_LIGGGHTS && !v.image)
		recompute_force(sim, &v, f);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t history = sim->neigh->contacts.history_width;
	size_t width = ts_contact_columns_width(&s->columns, history);
	struct ts_contact_facts facts;
	struct ts_contact_rows rows;
	enum ts_status status;

	TS_TRY(ts_contacts_forces(s->sim, self));
	TS_TRY(ts_contact_rows(s->sim, self->group, true, &rows));
	status = ts_table_resize(out, rows.n, width);
	for (size_t n = 0; n < rows.n && status == TS_OK; n++) {
		collect_facts(sim, rows.row[n].r, s->columns.wanted, &facts);
		ts_contact_columns_write(&s->columns, history, &facts, out->data + width * n);
	}
	ts_contact_rows_release(&rows);
	return status;
}

static const struct ts_value values[] = {
	{ "list", "", "a row for each contact", TS_LOCAL, 0, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REST_OPTIONAL("quantities", struct state, columns.words, .help = ts_contact_columns_help),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_pair_gran_local)
const struct ts_style ts_compute_pair_gran_local = {
	.name = "pair/gran/local",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
	.summary = "Forces, positions and other quantities of each contact",
	.doc = "A table with a row for each contact whose particles are both in the group. The particle with "
	       "the smaller ID is the first. The columns follow in this order, whatever the order of the "
	       "words: pos, positions of both (6); vel, velocities of both (6); id, both IDs, and 1 if the "
	       "contact is across a periodic face, else 0 (3); force on the first (3); its normal and "
	       "tangential parts force_normal (3) and force_tangential (3); torque on the first about "
	       "its centre, by the tangential force and rolling friction (3); history, the history "
	       "numbers of the contact law; contactArea, area of the circle in which the spheres intersect "
	       "(1); delta, the overlap (1); contactPoint, which divides the line of centres in the ratio of "
	       "the radii (3); heatFlux, heat per time that fix heat/gran conducts into the first (1). "
	       "Without words: pos vel id force history contactArea.\n\n"
	       "Contacts and forces are those of the last force computation; positions and velocities are "
	       "the present ones. LIGGGHTS computes the forces again with the velocities at the end of the "
	       "step, which differs by half a step of damping; tsim does the same with `legacy yes`. With "
	       "these columns `dump local/gran/vtk` shows force chains.",
	.example = "compute c all pair/gran/local id pos force delta\n"
		   "dump d all local 100 post/contacts*.txt c_c[7] c_c[8] c_c[10] c_c[13]",
	.args = args,
	.family = TS_FAMILY_CONTACTS,
	.state_size = sizeof(struct state),
	.values = values,
	.width = ts_contact_columns_known_width,
	.init = init,
};
