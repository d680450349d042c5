#include "geom/primitive.h"
#include "law/granular_force.h"
#include "neigh/materials.h"
#include "neigh/pair.h"
#include "neigh/wall_contacts.h"
#include "particles/domain.h"
#include "particles/particles.h"

#include <math.h>

#include "core/plan.h"

#include "base/banned.h"

enum { NSHAPES = 6 };

struct wall {
	struct ts_granular_words words;
	bool primitive_word;
	int64_t type;
	double plane[3], cylinder[3][3]; /* as given; NaN: not given */
	double velocity[3];
	bool store_force;
	int shape; /* enum ts_primitive_shape */
	struct ts_primitive primitive;
	bool own_model; /* else that of the pair style */
	struct ts_granular_model model;
	struct ts_granular_pair *law; /* by particle type, of the own model */
	int ntypes;
	struct ts_wall_contacts contacts; /* particles that may touch before the next rebuild */
	double force[3];		  /* on the wall, in the last step */
};

/* Which of the shapes is given; the first two are an error. */
static enum ts_status choose_shape(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;
	int given = 0;

	for (int k = 0; k < NSHAPES; k++) {
		const double *value = k < 3 ? &w->plane[k] : w->cylinder[k - 3];

		if (isnan(*value))
			continue;
		given++;
		w->shape = k;
		w->primitive.position = w->primitive.radius = value[0];
		w->primitive.centre[0] = k < 3 ? 0 : value[1];
		w->primitive.centre[1] = k < 3 ? 0 : value[2];
	}
	w->primitive.shape = (enum ts_primitive_shape)w->shape;
	if (given == 1)
		return TS_OK;
	return ts_fail(
		&sim->error, TS_SYNTAX, &self->where,
		"fix wall/gran: expected one of xplane, yplane, zplane, xcylinder, ycylinder, "
		"zcylinder, found %d of them",
		given);
}

static enum ts_status check_shape(struct ts_instance *self, struct tsim *sim)
{
	const struct wall *w = self->state;
	int dim = w->shape % 3;

	if (w->shape >= TS_XCYLINDER && !(w->primitive.radius > 0))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix wall/gran: the radius of a cylinder must be > 0");
	if (w->shape <= TS_ZPLANE && ts_sim_has_box(sim) && ts_box_periodic(&sim->domain->box, dim))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix wall/gran: a plane wall across the periodic dimension %c",
			       'x' + dim);
	return TS_OK;
}

/* The constants of the own model for each type that particles have. */
static enum ts_status make_laws(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;
	const struct ts_particles *p = sim->particles;
	int most = 0;

	if (w->ntypes < p->ntypes)
		w->law = ts_arena_alloc(&self->arena, (size_t)p->ntypes + 1, sizeof *w->law);
	if (p->ntypes && !w->law)
		return ts_nomem(&sim->error);
	w->ntypes = p->ntypes;
	for (size_t i = 0; i < p->n; i++)
		most = p->type[i] > most ? p->type[i] : most;
	for (int t = 1; t <= most; t++)
		TS_TRY(ts_granular_material(sim, &w->model, t, (int)w->type, "fix wall/gran",
					    &self->where, &w->law[t]));
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;

	TS_TRY(choose_shape(self, sim));
	TS_TRY(check_shape(self, sim));
	w->own_model = w->words.normal != TS_NORMAL_OFF;
	if (!w->own_model)
		return TS_OK;
	w->model = ts_granular_model_of(sim, &w->words);
	return ts_granular_turns(&w->model)
		       ? ts_particles_need(sim, TS_NEED(OMEGA) | TS_NEED(TORQUE))
		       : TS_OK;
}

static const struct ts_pair *pair_of(const struct tsim *sim)
{
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);

	return pair ? pair->state : NULL;
}

static const struct ts_granular_model *model_of(const struct wall *w, const struct tsim *sim)
{
	return w->own_model ? &w->model : &pair_of(sim)->model;
}

static const struct ts_granular_pair *law_of(const struct wall *w, const struct tsim *sim, int type)
{
	return w->own_model ? &w->law[type] : ts_pair_law(pair_of(sim), type, (int)w->type);
}

static enum ts_status list_near(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;
	const struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++) {
		double n[3];

		if (!ts_in_group(p, i, self->group) || p->imass[i] == 0)
			continue;
		if (ts_primitive_distance(&w->primitive, p->xhold[i], n) <
		    p->radius[i] + sim->neigh->built_skin)
			TS_TRY(ts_wall_contacts_add(sim, &w->contacts, i, 0));
	}
	return TS_OK;
}

static enum ts_status post_build(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;
	struct ts_wall_rebuild rebuild;
	enum ts_status status;

	if (!w->own_model && !pair_of(sim))
		return TS_OK; /* refused by the plan */
	if (w->own_model)
		TS_TRY(make_laws(self, sim));
	ts_wall_contacts_start(&w->contacts, &rebuild,
			       (size_t)ts_granular_memory(model_of(w, sim)));
	status = list_near(self, sim);
	if (status == TS_OK)
		return ts_wall_contacts_finish(sim, &w->contacts, &rebuild);
	ts_wall_contacts_release(&rebuild.old);
	return status;
}

/* The wall is the limit of an infinitely heavy partner whose surface is flat. */
static bool touch(const struct wall *w, const struct ts_granular_model *model,
		  const struct ts_particles *p, size_t i, struct ts_touch *t)
{
	static const double at_rest[3] = { 0 };
	double v[3];

	*t = (struct ts_touch){ .wall = true };
	t->distance = ts_primitive_distance(&w->primitive, p->x[i], t->n);
	t->radius[0] = t->r_eff = p->radius[i];
	t->mass[0] = t->m_eff = p->mass[i];
	t->overlap = p->radius[i] - t->distance;
	ts_granular_arms(model, t);
	ts_sub(p->v[i], w->velocity, v);
	ts_touch_motion(t, v, p->omega ? p->omega[i] : at_rest, at_rest);
	return t->overlap > 0;
}

static void add_torque(struct ts_particles *p, size_t i, const struct ts_touch *t,
		       const struct ts_granular_force *f)
{
	for (int k = 0; k < 3; k++)
		p->torque[i][k] += t->arm[0] * f->turn[k] + f->roll[k];
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;
	struct ts_particles *p = sim->particles;
	const struct ts_granular_model *model;

	w->force[0] = w->force[1] = w->force[2] = 0;
	if (!w->contacts.n)
		return TS_OK;
	model = model_of(w, sim);
	for (size_t k = 0; k < w->contacts.n; k++) {
		size_t i = (size_t)w->contacts.row[k];
		struct ts_granular_force f;
		struct ts_touch t;

		if (!touch(w, model, p, i, &t)) {
			ts_wall_contact_part(&w->contacts, k);
			continue;
		}
		ts_granular_contact(model, law_of(w, sim, p->type[i]), &t, sim->clock.dt,
				    !sim->in_setup, ts_wall_memory(&w->contacts, k), &f);
		ts_add(p->f[i], f.force, p->f[i]);
		ts_sub(w->force, f.force, w->force);
		if (ts_granular_turns(model))
			add_torque(p, i, &t, &f);
	}
	return TS_OK;
}

static enum ts_status setup_check(struct ts_instance *self, struct tsim *sim)
{
	const struct wall *w = self->state;
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	const struct ts_pair *state;

	if (w->own_model)
		return TS_OK;
	if (!pair)
		return ts_fail(
			&sim->error, TS_STATE, &self->where,
			"fix wall/gran takes the contact law of the pair_style, and there is none");
	state = pair->state;
	if (w->type > state->ntypes)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix wall/gran: type %d does not exist, create_box made %d",
			       (int)w->type, state->ntypes);
	for (size_t i = 0; i < sim->particles->n; i++) {
		int type = sim->particles->type[i];

		if (ts_in_group(sim->particles, i, self->group) &&
		    !state->coeffs.given[type * (state->ntypes + 1) + w->type])
			return ts_fail(
				&sim->error, TS_STATE, &self->where,
				"a wall of type %d meets particles of type %d, but there is no "
				"`pair_coeff %d %d ...`",
				(int)w->type, type, type, (int)w->type);
	}
	return TS_OK;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim,
			   struct ts_plan_report *report)
{
	const struct wall *w = self->state;
	const struct ts_particles *p = sim->particles;
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	double least = INFINITY;
	int type = 0;

	TS_TRY(setup_check(self, sim));
	for (size_t i = 0; i < p->n; i++) {
		if (!ts_in_group(p, i, self->group) || !(p->mass[i] < least))
			continue;
		least = p->mass[i];
		type = p->type[i];
	}
	if (!type || w->own_model || !ts_pair_style_of(pair)->limit)
		return TS_OK;
	return ts_report_limit(
		report,
		ts_pair_style_of(pair)->limit(ts_pair_law(pair->state, type, (int)w->type), least,
					      sim->explicit_euler),
		!sim->explicit_euler, &self->where, "a contact with wall %s (m* = %.4g)", self->id,
		least);
}

static enum ts_status eval_force(struct ts_instance *self, const struct tsim *sim,
				 struct ts_table *out)
{
	const struct wall *w = self->state;

	(void)sim;
	for (int k = 0; k < 3; k++)
		out->data[k] = w->force[k];
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	return ts_wall_contacts_archive(a, sim, &((struct wall *)self->state)->contacts);
}

static void fini(struct ts_instance *self)
{
	ts_wall_contacts_release(&((struct wall *)self->state)->contacts);
}

#define PLANE(axis, k)                                                                             \
	TS_REAL(axis "plane", struct wall, plane[k], .flags = TS_OPTIONAL, .unit = "length",       \
		.help = "the plane " axis " = this")
#define CYLINDER(axis, k, first, second)                                                           \
	TS_VEC3(axis "cylinder", struct wall, cylinder[k], .flags = TS_OPTIONAL, .unit = "length", \
		.help = "cylinder along " axis ": radius, then its centre along " first            \
			" and " second)

static const struct ts_arg args[] = {
	TS_GRANULAR_ARGS(struct wall, words),
	TS_FLAG("primitive", struct wall, primitive_word,
		.help = "the wall is a plane or cylinder"),
	TS_INT("type", struct wall, type, .range = TS_POSITIVE,
	       .help = "particle type whose material the wall has"),
	PLANE("x", 0),
	PLANE("y", 1),
	PLANE("z", 2),
	CYLINDER("x", 0, "y", "z"),
	CYLINDER("y", 1, "z", "x"),
	CYLINDER("z", 2, "x", "y"),
	TS_VEC3("velocity", struct wall, velocity, .fallback = "0 0 0", .unit = "velocity",
		.help = "velocity of the surface in its own plane; the wall stays where it is"),
	TS_BOOL("store_force", struct wall, store_force, .fallback = "no", .help = "no effect yet"),
	TS_ARGS_END,
};

static const char *const force_names[] = { "fx", "fy", "fz" };
static const struct ts_value values[] = {
	{ "force", "force", "total force on the wall", TS_VECTOR, 3, force_names, eval_force },
	{ .name = NULL },
};

/* A run that goes on after a restart shows the force of the last step. */
static const struct ts_saved saved[] = { TS_SAVE_F64(struct wall, force), TS_SAVED_ROWS_END };

TS_STYLE(fix, ts_style, ts_fix_wall_gran)
const struct ts_style ts_fix_wall_gran = {
	.name = "wall/gran",
	.kind = TS_KIND_FIX,
	.summary = "a rigid wall with the contact law of the pair style",
	.doc = "The particles of the group meet the wall as they would an infinitely heavy partner "
	       "with a "
	       "flat surface: m* = m, R* = R. With `model ...` the wall has contact laws of its "
	       "own, "
	       "composed as for pair_style gran, with the material of its `type`; without, those "
	       "of the "
	       "pair style. Planes and cylinders are two-sided. On the axis of a cylinder there is "
	       "no "
	       "force. Each particle remembers its contact with the wall as with a partner. The "
	       "centre "
	       "of a cylinder is given along the next two axes in cyclic order: xcylinder y z, "
	       "ycylinder "
	       "z x, zcylinder x y.",
	.example = "fix floor all wall/gran model hertz tangential history primitive type 1 zplane "
		   "0.0\n"
		   "fix drum all wall/gran primitive type 2 zcylinder 0.05 0.0 0.0",
	.args = args,
	.state_size = sizeof(struct wall),
	.archive = archive,
	.values = values,
	.init = init,
	.saved = saved,
	.hook = { [TS_STAGE_POST_BUILD] = post_build, [TS_STAGE_POST_FORCE] = post_force },
	.plan = plan,
	.fini = fini,
};
