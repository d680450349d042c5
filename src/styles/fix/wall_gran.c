#include "geom/primitive.h"
#include "neigh/mesh_stress.h"
#include "neigh/wall.h"
#include "particles/domain.h"
#include "particles/particles.h"

#include <math.h>

#include "core/plan.h"

#include "base/banned.h"

enum { NSHAPES = 6 };

struct wall {
	struct ts_wall wall;
	bool primitive_word, mesh_word;
	int64_t type, nmeshes;
	struct ts_words meshes;
	double plane[3], cylinder[3][3]; /* as given; NaN: not given */
	double velocity[3];
	bool store_force;
	int shape; /* enum ts_primitive_shape */
	struct ts_primitive primitive;
	struct ts_mesh_wall mesh;
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
	if (given == !w->mesh_word)
		return TS_OK;
	if (w->mesh_word)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix wall/gran: a wall is a mesh or a primitive, not both");
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

	if (w->type == INT64_MIN)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix wall/gran primitive: which `type`?");
	if (w->shape >= TS_XCYLINDER && !(w->primitive.radius > 0))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix wall/gran: the radius of a cylinder must be > 0");
	if (w->shape <= TS_ZPLANE && ts_sim_has_box(sim) && ts_box_periodic(&sim->domain->box, dim))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix wall/gran: a plane wall across the periodic dimension %c",
			       'x' + dim);
	return TS_OK;
}

static enum ts_status find_meshes(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;

	if (!w->meshes.n)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix wall/gran mesh: which meshes? `n_meshes 1 meshes ID`");
	if (w->nmeshes != INT64_MIN && w->nmeshes != (int64_t)w->meshes.n)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "n_meshes"),
			       "fix wall/gran: n_meshes is %d, but %zu meshes are named",
			       (int)w->nmeshes, w->meshes.n);
	if (w->type != INT64_MIN)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "type"),
			       "fix wall/gran: each mesh has the type that its fix says");
	TS_TRY(ts_mesh_wall_find(self, sim, &w->mesh, w->meshes));
	w->wall.contacts.want_reports |= ts_mesh_stress_wanted(&w->mesh);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;

	TS_TRY(choose_shape(self, sim));
	TS_TRY(w->mesh_word ? find_meshes(self, sim) : check_shape(self, sim));
	w->wall.meshes = w->mesh_word ? (int)w->mesh.nmeshes : 0;
	return ts_wall_init(self, sim);
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
			TS_TRY(ts_wall_contacts_add(sim, &w->wall.contacts, i, 0));
	}
	return TS_OK;
}

/* The particle types whose materials the wall has: one of each mesh. */
static size_t ntypes(const struct wall *w)
{
	return w->mesh_word ? w->mesh.nmeshes : 1;
}

static int type_of(const struct wall *w, size_t k)
{
	return (int)(w->mesh_word ? w->mesh.mesh[k].surface->type : w->type);
}

static enum ts_status post_build(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;
	struct ts_wall_rebuild rebuild;

	if (!ts_wall_has_law(&w->wall, sim))
		return TS_OK; /* refused by the plan */
	for (size_t k = 0; k < ntypes(w); k++)
		TS_TRY(ts_wall_make_law(self, sim, type_of(w, k)));
	ts_wall_rebuild_start(&w->wall, sim, w->mesh_word ? TS_MESH_MEMORY : 0, &rebuild);
	return ts_wall_rebuild_finish(&w->wall, sim, &rebuild,
				      w->mesh_word
					      ? ts_mesh_wall_list(self, sim, &w->wall, &w->mesh)
					      : list_near(self, sim));
}

static enum ts_status check(struct ts_instance *self, struct tsim *sim)
{
	const struct wall *w = self->state;

	if (w->mesh_word && ts_mesh_wall_has_moved(sim, &w->mesh))
		sim->rebuild = true;
	return TS_OK;
}

static void push_from_primitive(struct tsim *sim, struct wall *w)
{
	struct ts_wall *wall = &w->wall;
	const struct ts_particles *p = sim->particles;
	struct ts_wall_spot spot = { .type = (int)w->type };

	for (int d = 0; d < 3; d++)
		spot.velocity[d] = w->velocity[d];
	for (size_t k = 0; k < wall->contacts.n; k++) {
		size_t i = (size_t)wall->contacts.row[k];

		spot.distance = ts_primitive_distance(&w->primitive, p->x[i], spot.n);
		if (spot.distance < p->radius[i])
			ts_wall_push(wall, sim, k, &spot);
		else
			ts_wall_contact_part(&wall->contacts, k);
	}
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;

	w->wall.force[0] = w->wall.force[1] = w->wall.force[2] = 0;
	if (!w->mesh_word) {
		push_from_primitive(sim, w);
		return TS_OK;
	}
	ts_mesh_wall_push(sim, &w->wall, &w->mesh);
	return ts_mesh_stress_collect(sim, &w->wall, &w->mesh);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim,
			   struct ts_plan_report *report)
{
	const struct wall *w = self->state;

	for (size_t k = 0; k < ntypes(w); k++)
		TS_TRY(ts_wall_plan(self, sim, type_of(w, k), report));
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_mesh_wall_release(&((struct wall *)self->state)->mesh);
	ts_wall_fini(self);
}

#define PLANE(axis, k)                                                                             \
	TS_REAL(axis "plane", struct wall, plane[k], .flags = TS_OPTIONAL, .unit = "length",       \
		.help = "the plane " axis " = this")
#define CYLINDER(axis, k, first, second)                                                           \
	TS_VEC3(axis "cylinder", struct wall, cylinder[k], .flags = TS_OPTIONAL, .unit = "length", \
		.help = "cylinder along " axis ": radius, then its centre along " first            \
			" and " second)

static const struct ts_arg args[] = {
	TS_GRANULAR_ARGS(struct wall, wall.words),
	TS_FLAG("primitive", struct wall, primitive_word,
		.help = "the wall is a plane or cylinder"),
	TS_INT("type", struct wall, type, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
	       .help = "primitive: particle type whose material the wall has"),
	TS_FLAG("mesh", struct wall, mesh_word, .help = "the wall is made of meshes"),
	TS_INT("n_meshes", struct wall, nmeshes, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
	       .help = "mesh: how many"),
	TS_SOME_KEYWORD("meshes", struct wall, meshes, TS_STATEFUL, .count = "n_meshes",
			.help = "mesh: IDs of their fixes; each has the material of its own type"),
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

static const struct ts_value values[] = {
	TS_WALL_FORCE_VALUE,
	{ .name = NULL },
};

/* A run that goes on after a restart shows the force of the last step. */
static const struct ts_saved saved[] = {
	{ "force", TS_SAVED_F64, offsetof(struct wall, wall.force), 3 },
	TS_SAVED_ROWS_END,
};

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
	       "z x, zcylinder x y.\n\n"
	       "A wall of meshes is met in faces, edges and corners, from both sides; particles of the groups of\n"
	       "both fixes meet it. fix mesh/surface says which edges and corners count. A contact that moves\n"
	       "from one triangle to a flat neighbour goes on with what it remembers.",
	.example = "fix floor all wall/gran model hertz tangential history primitive type 1 zplane "
		   "0.0\n"
		   "fix drum all wall/gran primitive type 2 zcylinder 0.05 0.0 0.0\n"
		   "fix walls all wall/gran model hertz tangential history mesh n_meshes 2 meshes cad1 "
		   "cad2",
	.args = args,
	.family = TS_FAMILY_WALL,
	.state_size = sizeof(struct wall),
	.archive = ts_wall_archive,
	.values = values,
	.init = init,
	.saved = saved,
	.hook = { [TS_STAGE_CHECK] = check,
		  [TS_STAGE_POST_BUILD] = post_build, [TS_STAGE_POST_FORCE] = post_force },
	.plan = plan,
	.fini = fini,
};
