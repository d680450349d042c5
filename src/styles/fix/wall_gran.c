#include "geom/primitive.h"
#include "neigh/pair.h"
#include "particles/domain.h"
#include "particles/particles.h"

#include <math.h>

#include "core/plan.h"

#include "base/banned.h"

struct wall {
	int kind, shape;
	int64_t type;
	double arg[3];
	double velocity[3];
	struct ts_primitive primitive;
	int32_t *near; /* particles that may touch before the next rebuild */
	size_t nnear, near_capacity;
	double force[3]; /* on the wall, in the last step */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;
	int dim = w->shape % 3;

	w->primitive.shape = (enum ts_primitive_shape)w->shape;
	w->primitive.position = w->primitive.radius = w->arg[0];
	w->primitive.centre[0] = w->arg[1];
	w->primitive.centre[1] = w->arg[2];
	if (w->shape >= TS_XCYLINDER && !(w->arg[0] > 0))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix wall/gran: the radius of a cylinder must be > 0");
	if (w->shape <= TS_ZPLANE && ts_sim_has_box(sim) && ts_box_periodic(&sim->domain->box, dim))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix wall/gran: a plane wall across the periodic dimension %c",
			       'x' + dim);
	return TS_OK;
}

static enum ts_status post_build(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;
	const struct ts_particles *p = sim->particles;

	w->nnear = 0;
	for (size_t i = 0; i < p->n; i++) {
		double n[3];

		if (!ts_in_group(p, i, self->group) || p->imass[i] == 0)
			continue;
		if (ts_primitive_distance(&w->primitive, p->xhold[i], n) >=
		    p->radius[i] + sim->neigh->built_skin)
			continue;
		if (TS_GROW(w->near, w->near_capacity, w->nnear + 1) != TS_OK)
			return ts_nomem(&sim->error);
		w->near[w->nnear++] = (int32_t)i;
	}
	return TS_OK;
}

/* The wall is the limit of an infinitely heavy partner whose surface is flat. */
static bool touch(const struct wall *w, const struct ts_particles *p, size_t i,
		  struct ts_contact *c)
{
	double distance = ts_primitive_distance(&w->primitive, p->x[i], c->n);

	c->overlap = p->radius[i] - distance;
	c->mass = p->mass[i];
	c->vn = 0;
	for (int k = 0; k < 3; k++)
		c->vn += (p->v[i][k] - w->velocity[k]) * c->n[k];
	return c->overlap > 0;
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;
	struct ts_particles *p = sim->particles;
	struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	const struct ts_pair_style *style;

	w->force[0] = w->force[1] = w->force[2] = 0;
	if (!w->nnear)
		return TS_OK;
	style = ts_pair_style_of(pair);
	for (size_t k = 0; k < w->nnear; k++) {
		size_t i = (size_t)w->near[k];
		struct ts_contact c;
		double fn;

		if (!touch(w, p, i, &c))
			continue;
		fn = style->law(ts_pair_coeff(pair->state, p->type[i], (int)w->type), &c, NULL);
		for (int d = 0; d < 3; d++) {
			p->f[i][d] += fn * c.n[d];
			w->force[d] -= fn * c.n[d];
		}
	}
	return TS_OK;
}

static enum ts_status setup_check(struct ts_instance *self, struct tsim *sim)
{
	const struct wall *w = self->state;
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	const struct ts_pair *state;

	if (!pair)
		return ts_fail(&sim->error, TS_STATE, &self->where,
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
			return ts_fail(&sim->error, TS_STATE, &self->where,
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
	if (!type)
		return TS_OK;
	return ts_report_limit(
		report,
		ts_pair_style_of(pair)->limit(ts_pair_coeff(pair->state, type, (int)w->type), least,
					      sim->explicit_euler),
		!sim->explicit_euler, &self->where, "a contact with wall %s (m* = %.4g)", self->id, least);
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

static void fini(struct ts_instance *self)
{
	ts_free(((struct wall *)self->state)->near);
}

static const char *const kinds[] = { "primitive", NULL };

static const struct ts_arg plane_rows[] = {
	TS_REAL("position", struct wall, arg[0], .flags = TS_POSITIONAL, .unit = "length",
		.help = "coordinate of the plane"),
	TS_ARGS_END,
};
static const struct ts_arg cylinder_rows[] = {
	TS_REAL("radius", struct wall, arg[0], .flags = TS_POSITIONAL, .unit = "length",
		.help = "radius of the cylinder"),
	TS_REAL("c1", struct wall, arg[1], .flags = TS_POSITIONAL, .unit = "length",
		.help = "centre along the next axis in cyclic order"),
	TS_REAL("c2", struct wall, arg[2], .flags = TS_POSITIONAL, .unit = "length",
		.help = "centre along the axis after that"),
	TS_ARGS_END,
};
static const struct ts_mode shapes[] = {
	{ "xplane", "plane x = position", plane_rows },
	{ "yplane", "plane y = position", plane_rows },
	{ "zplane", "plane z = position", plane_rows },
	{ "xcylinder", "cylinder along x, centre y z", cylinder_rows },
	{ "ycylinder", "cylinder along y, centre z x", cylinder_rows },
	{ "zcylinder", "cylinder along z, centre x y", cylinder_rows },
	{ .name = NULL },
};

static const char *const type_word[] = { "type", NULL };
struct wall_words {
	struct wall wall;
	int type_word;
};

static const struct ts_arg args[] = {
	TS_ENUM("kind", struct wall_words, wall.kind, kinds, .flags = TS_POSITIONAL,
		.help = "what the wall is made of"),
	TS_ENUM("word", struct wall_words, type_word, type_word, .flags = TS_POSITIONAL,
		.help = "the word `type`"),
	TS_INT("material", struct wall_words, wall.type, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "particle type whose coefficients the wall has"),
	TS_MODE("shape", struct wall_words, wall.shape, shapes, .help = "shape and place"),
	TS_VEC3("velocity", struct wall_words, wall.velocity, .fallback = "0 0 0", .unit = "velocity",
		.help = "velocity of the surface in its own plane; the wall stays where it is"),
	TS_ARGS_END,
};

static const char *const force_names[] = { "fx", "fy", "fz" };
static const struct ts_value values[] = {
	{ "force", "force", "total force on the wall", TS_VECTOR, 3, force_names, eval_force },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_wall_gran)
const struct ts_style ts_fix_wall_gran = {
	.name = "wall/gran",
	.kind = TS_KIND_FIX,
	.summary = "a rigid wall with the contact law of the pair style",
	.doc = "The particles of the group meet the wall as they would an infinitely heavy partner with "
	       "a flat surface: same law, same coefficients (those of the particle's type and the "
	       "wall's `type`), m* = m. Planes and cylinders are two-sided. On the axis of a cylinder "
	       "there is no force.",
	.example = "fix floor all wall/gran primitive type 1 zplane 0.0\n"
		   "fix drum all wall/gran primitive type 2 zcylinder 0.05 0.0 0.0",
	.args = args,
	.state_size = sizeof(struct wall_words),
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_POST_BUILD] = post_build, [TS_STAGE_POST_FORCE] = post_force },
	.plan = plan,
	.fini = fini,
};
