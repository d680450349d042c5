#include "impact/exact_impacts.h"
#include "impact/impacts.h"
#include "wall/mesh_wall_queue.h"
#include "wall/primitive_wall.h"
#include "wall/surface_contacts.h"
#include "wall/voxel_wall_queue.h"
#include "wall/wall_coincide.h"
#include "wall/wall_law.h"

#include <math.h>

#include "core/sim.h"

#include "base/banned.h"

struct wall {
	struct ts_wall wall;
	bool primitive_word, mesh_word;
	int64_t type, nmeshes;
	struct ts_words meshes;
	const char *voxels; /* ID of the fix of a height field; NULL: a mesh or a primitive */
	struct ts_wall_law law;
	struct ts_primitive_wall primitive;
	struct ts_mesh_wall mesh;
	struct ts_voxel_wall voxel;
	int impact; /* EXACT: `impact exact` */
};

enum { EXACT = 1 };
static const char *const impacts[] = { "resolved", "exact", NULL };

static enum ts_status check_shape(struct ts_instance *self, struct tsim *sim)
{
	const struct wall *w = self->state;
	int given = ts_primitive_wall_shapes(&w->primitive);

	if (given + w->mesh_word + (w->voxels != NULL) == 1)
		return TS_OK;
	if (w->mesh_word || w->voxels)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix wall/gran: a wall is a mesh, a height field or a primitive, one of them");
	return ts_fail(&sim->error, TS_SYNTAX, &self->where,
		       "fix wall/gran: expected one of xplane, yplane, zplane, xcylinder, ycylinder, "
		       "zcylinder, found %d of them%s",
		       given, given ? "" : "; or `mesh n_meshes 1 meshes ID`, or `voxels ID`");
}

static enum ts_status find_meshes(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;

	if (!w->meshes.n)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix wall/gran mesh: which meshes? `n_meshes 1 meshes ID`");
	if (w->nmeshes != INT64_MIN && w->nmeshes != (int64_t)w->meshes.n)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "n_meshes"),
			       "fix wall/gran: n_meshes is %d, but %zu meshes are named", (int)w->nmeshes,
			       w->meshes.n);
	if (w->type != INT64_MIN)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "type"),
			       "fix wall/gran: each mesh has the type that its fix says");
	if (ts_wall_has_law(&w->wall, sim) && ts_cohesion_bridges(ts_wall_model(&w->wall, sim)))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix wall/gran: bridges of liquid reach beyond the touch, which contacts with "
			       "triangles do "
			       "not follow; take a plane, a cylinder or a region, or leave cohesion out");
	return ts_mesh_wall_find(self, sim, &w->mesh, w->meshes);
}

static enum ts_status find_surface(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;
	struct ts_word id = { .text = w->voxels, .place = *ts_instance_word(self, w->voxels) };

	if (w->type != INT64_MIN)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "type"),
			       "fix wall/gran: a height field has the type that its fix says");
	return ts_voxel_wall_find(sim, &w->voxel, &id);
}

static enum ts_status place_primitive(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;

	if (w->type == INT64_MIN && !w->wall.given)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix wall/gran primitive: which `type`?");
	if (w->type == INT64_MIN) /* LAMMPS' walls have no material */
		w->type = 1;
	w->primitive.lammps = w->wall.given;
	return ts_primitive_wall_read(self, sim, &w->primitive);
}

static double contact_distance(const struct ts_instance *self, const struct tsim *sim, size_t k, int *type)
{
	const struct wall *w = self->state;
	const struct ts_wall_contacts *c = &w->wall.contacts;
	size_t i = (size_t)c->row[k];

	if (w->voxels) {
		*type = (int)w->voxel.surface->type;
		return ts_voxel_wall_distance(&w->voxel, sim, sim->particles->x[i],
					      sim->particles->radius[i]);
	}
	*type = (int)(w->mesh_word ? w->mesh.mesh[ts_mesh_wall_near(&w->mesh, k)->mesh].surface->type
				   : w->type);
	return w->mesh_word
		       ? ts_mesh_wall_distance(sim, &w->mesh, k, i)
		       : ts_primitive_wall_distance(&w->primitive, sim, c->key[k][1], sim->particles->x[i]);
}

static enum ts_status check_type(struct tsim *sim, int64_t type, const struct ts_place *where)
{
	if (type <= sim->particles->ntypes || !sim->particles->ntypes)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, where,
		       "fix wall/gran: the wall is of type %lld, but create_box made %d", (long long)type,
		       sim->particles->ntypes);
}

/* A type that does not exist is a frequent error: reported here rather than by a material property with
 * too few values. */
static enum ts_status check_types(struct ts_instance *self, struct tsim *sim)
{
	const struct wall *w = self->state;

	if (w->wall.given) /* numbers, no material */
		return TS_OK;
	if (w->voxels)
		return check_type(sim, w->voxel.surface->type, ts_instance_word(self, w->voxels));
	if (!w->mesh_word)
		return check_type(sim, w->type, ts_instance_word(self, "type"));
	for (size_t k = 0; k < w->mesh.nmeshes; k++)
		TS_TRY(check_type(sim, w->mesh.mesh[k].surface->type,
				  ts_instance_word(self, w->meshes.word[k].text)));
	return TS_OK;
}

static enum ts_status init_exact(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;

	if (w->impact != EXACT)
		return TS_OK;
	w->primitive.type = (int)w->type;
	if (w->voxels)
		return ts_exact_init(self, sim, &ts_voxel_wall_exact, &w->voxel);
	if (!w->mesh_word && ts_primitive_wall_pumps(&w->primitive))
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "impact"),
			       "fix wall/gran impact exact: the surface of a plane that stays in place has "
			       "no velocity "
			       "along its normal");
	return w->mesh_word ? ts_exact_init(self, sim, &ts_mesh_wall_exact, &w->mesh)
			    : ts_exact_init(self, sim, &ts_primitive_wall_exact, &w->primitive);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;

	TS_TRY(check_shape(self, sim));
	TS_TRY(ts_wall_law_choose(self, sim, &w->law, &w->wall));
	TS_TRY(w->voxels      ? find_surface(self, sim)
	       : w->mesh_word ? find_meshes(self, sim)
			      : place_primitive(self, sim));
	TS_TRY(check_types(self, sim));
	TS_TRY(init_exact(self, sim));
	w->wall.primitive = w->mesh_word || w->voxels ? NULL : &w->primitive;
	w->wall.type = (int)w->type;
	w->wall.distance = contact_distance;
	w->wall.meshes = w->voxels ? 1 : w->mesh_word ? (int)w->mesh.nmeshes : 0;
	w->wall.mesh = w->mesh_word ? &w->mesh : NULL;
	w->wall.voxel = w->voxels ? &w->voxel : NULL;
	w->wall.surfaces = w->voxels	  ? &ts_voxel_wall_surfaces
			   : w->mesh_word ? &ts_mesh_wall_surfaces
					  : &ts_primitive_wall_surfaces;
	w->wall.moves = w->wall.primitive && ts_primitive_wall_moves(&w->primitive);
	w->wall.warm = (w->wall.primitive && !isnan(w->primitive.temperature)) ||
		       (w->voxels && !isnan(w->voxel.surface->temperature));
	for (size_t k = 0; w->mesh_word && k < w->mesh.nmeshes; k++)
		w->wall.warm |= !isnan(w->mesh.mesh[k].surface->temperature);
	return ts_wall_init(self, sim);
}

/* Number of particle types whose materials the wall has: one for each mesh. */
static size_t count_surface_types(const struct wall *w)
{
	return w->mesh_word ? w->mesh.nmeshes : 1;
}

static int surface_type(const struct wall *w, size_t k)
{
	return (int)(w->voxels	    ? w->voxel.surface->type
		     : w->mesh_word ? w->mesh.mesh[k].surface->type
				    : w->type);
}

static enum ts_status post_build(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;
	struct ts_wall_rebuild rebuild;

	if (!ts_wall_has_law(&w->wall, sim))
		return TS_OK; /* refused by the plan */
	for (size_t k = 0; k < count_surface_types(w); k++)
		TS_TRY(ts_wall_make_law(self, sim, surface_type(w, k)));
	TS_TRY(ts_surface_contacts_find_observers(sim, &w->wall));
	if (w->voxels) {
		TS_TRY(ts_voxel_wall_list(self, sim, &w->wall, &w->voxel, false));
		return ts_impacts_prepare(self, sim);
	}
	ts_wall_rebuild_start(&w->wall, sim, w->mesh_word ? TS_MESH_MEMORY : 0, &rebuild);
	TS_TRY(ts_wall_rebuild_finish(&w->wall, sim, &rebuild,
				      w->mesh_word
					      ? ts_mesh_wall_list(self, sim, &w->wall, &w->mesh)
					      : ts_primitive_wall_list(self, sim, &w->wall, &w->primitive)));
	return ts_impacts_prepare(self, sim);
}

static enum ts_status check(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;

	if (w->voxels) {
		sim->run.rebuild |= ts_voxel_wall_has_moved(sim, &w->voxel);
		return w->wall.exact ? TS_OK : ts_voxel_wall_check_displacement(self, sim, &w->voxel);
	}
	sim->run.rebuild |= w->mesh_word ? ts_mesh_wall_has_moved(sim, &w->mesh)
					 : ts_primitive_wall_has_moved(sim, &w->primitive);
	if (w->wall.exact) /* also finds what it passes */
		return TS_OK;
	return w->mesh_word ? ts_mesh_wall_check_displacement(self, sim, &w->mesh)
			    : ts_primitive_wall_check_displacement(self, sim, &w->primitive);
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;

	ts_wall_start(&w->wall, sim);
	TS_TRY(w->voxels ? ts_voxel_wall_enqueue_contacts(self, sim, &w->wall, &w->voxel)
	       : w->mesh_word
		       ? ts_mesh_wall_enqueue_contacts(sim, &w->wall, &w->mesh)
		       : ts_primitive_wall_enqueue_contacts(sim, &w->wall, &w->primitive, (int)w->type));
	ts_exact_add_force(&w->wall, sim);
	TS_TRY(ts_surface_contacts_collect(sim, &w->wall));
	return ts_impacts_update(sim, &w->wall);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct wall *w = self->state;

	if (w->wall.primitive)
		ts_primitive_wall_plan(self, sim, &w->primitive);
	for (size_t k = 0; k < count_surface_types(w); k++)
		TS_TRY(ts_wall_plan(self, sim, surface_type(w, k), report));
	return w->wall.exact ? ts_exact_plan(self, sim) : TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_mesh_wall_release(&((struct wall *)self->state)->mesh);
	ts_voxel_wall_release(&((struct wall *)self->state)->voxel);
	ts_impacts_free(((struct wall *)self->state)->wall.impacts);
	ts_exact_fini(self->state);
	ts_wall_fini(self);
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	TS_TRY(ts_primitive_wall_archive(a, &((struct wall *)self->state)->primitive));
	TS_TRY(ts_exact_archive(a, sim, self->state));
	TS_TRY(ts_wall_archive(self, sim, a));
	return ts_impacts_archive(a, sim, self->state);
}

static const struct ts_arg args[] = {
	TS_GRANULAR_ARGS(struct wall, wall.words),
	TS_WALL_LAW_ARGS(struct wall, law),
	TS_FLAG("primitive", struct wall, primitive_word, .help = "the wall is a plane or cylinder"),
	TS_INT("type", struct wall, type, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
	       .help = "primitive: particle type whose material the wall has"),
	TS_FLAG("mesh", struct wall, mesh_word, .help = "the wall is made of meshes"),
	TS_INT("n_meshes", struct wall, nmeshes, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
	       .help = "mesh: number of meshes"),
	TS_SOME_KEYWORD("meshes", struct wall, meshes, TS_STATEFUL, .count = "n_meshes",
			.help = "mesh: IDs of the fixes of the meshes; each has the material of its own "
				"type"),
	TS_WORD("voxels", struct wall, voxels, .flags = TS_OPTIONAL | TS_STATEFUL,
		.help = "ID of the fix surface/voxel that the wall is made of; it has the material of its "
			"own "
			"type"),
	TS_PRIMITIVE_WALL_ARGS(struct wall, primitive),
	TS_ENUM("impact", struct wall, impact, impacts, .flags = TS_STATEFUL, .fallback = "resolved",
		.help = "resolved: contacts are resolved by time steps; exact: a particle that hits the wall "
			"alone is "
			"carried through the whole impact in one step"),
	TS_WALL_ARGS(struct wall, wall),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	TS_WALL_FORCE_VALUE,
	TS_WALL_CONTACTS_VALUE,
	{ .name = NULL },
};

/* Saved for the output at the first step after a restart. */
static const struct ts_saved saved[] = {
	{ "force", TS_SAVED_F64, offsetof(struct wall, wall.force), 3 },
	TS_SAVED_ROWS_END,
};

static const char doc[] =
	"Particles of the group interact with the wall by a contact law, as with a partner of infinite mass "
	"and a flat surface: the effective mass is m* = m, the effective radius R* = R. The history of a "
	"contact with the wall is stored for each particle, as that of a contact with another particle.\n\n"
	"The contact law is one of these:\n\n"
	"  model ...                  laws composed as for pair_style gran, with the material of `type`\n"
	"  hooke, hooke/history,\n"
	"  hertz/history ...          LAMMPS' laws with their constants\n"
	"  granular ...               LAMMPS' laws with the keywords of pair_coeff of pair_style granular\n"
	"  none of these              the law of the pair style, with the material of `type`\n\n"
	"A mesh has the material of the type of its own fix. A material given by `granular` is that of the "
	"particles, too: E* = E/(2 (1 - nu^2)), and k_t NULL is 8 G*. (LAMMPS of 29 Sep 2021 has E/(2 (1 - "
	"nu)) and E (2 - nu)(1 + nu)/4, as `legacy yes` has.)\n\n"
	"Planes and cylinders are two-sided: they repel a particle to the side where its centre is. A "
	"particle whose centre lies in the surface itself, within 1e-12 of its radius, is on neither side: "
	"the run is refused or stops. On the axis of a cylinder the distance is the same in all directions, "
	"and there is no force. A plane or mesh that moves by more than the radius of a particle near it in "
	"one step would pass through it without a contact: the run stops, and the message says which time "
	"step is small enough.\n\n"
	"The centre of a cylinder is given along the next two axes in cyclic order: xcylinder y z, "
	"ycylinder z x, zcylinder x y.\n\n"
	"`shear DIM V`: the surface moves with the velocity V along DIM, but the wall stays in place. If "
	"DIM is not the axis of a cylinder, the cylinder rotates about its axis. As in LIGGGHTS, V is then "
	"the angular velocity (radian/time), and a point of the surface at d from the axis of direction a "
	"has the velocity V a x d. (LIGGGHTS interchanges two components for ycylinder, as `legacy yes` "
	"does.) With the laws of LAMMPS, V is the speed of the surface, clockwise as seen from the tip of "
	"the axis. (LAMMPS' program adds V along DIM; here nothing is added.)\n\n"
	"`wiggle DIM A T`: the displacement is A (1 - cos(2 pi t/T)), t being the time since the definition "
	"of the fix. Along the surface only the velocity has an effect.\n\n"
	"`temperature T`: with fix heat/gran, each touching particle of temperature T_i receives the heat "
	"flow\n\n"
	"  Q = h (T - T_i),  h = 4 k k_wall/(k + k_wall) sqrt(A),\n\n"
	"k and k_wall being the conductivities. The contact area is A = pi (R^2 - r^2), r being the "
	"distance of the centre from the wall, or as `contact_area` says.\n\n"
	"`store_force yes` stores the force of the wall on each particle as f_force_ID[1] ... [3].\n\n"
	"A wall of meshes interacts with the particles of the groups of both this fix and the fix of the "
	"mesh, at faces, edges and corners and from both sides. See fix mesh/surface for the edges and "
	"corners that are active, and for the temperature of a mesh. A contact that moves from one triangle "
	"to a flat neighbour keeps its history. Laws that act beyond the touch (model jkr) do so on meshes "
	"as on planes: each point of the mesh that is nearest to the particle in all triangles that share "
	"it is one contact, which keeps its history when it moves across edges and corners, too.";

static const char *const doc_more[] = {
	"`voxels ID` makes a wall of a height field, see fix surface/voxel. Particles of the groups of both "
	"fixes interact with it from outside; a particle whose centre gets into the solid stops the run. "
	"Each "
	"point of the surface that is nearer to the centre than all other points around it is one contact: "
	"on a top, a side, an edge or a corner of the columns. A contact that slides to another column keeps "
	"its history: a new contact continues the one that has ended in the same step, of several that "
	"with the nearest normal, if the angle between the normals is less than 8 degrees.",
	"`impact exact`: a particle that hits the wall alone is carried through the whole impact in one time "
	"step. From the first touch on its path the motion under the contact law is integrated until the "
	"surfaces separate; the free flight then continues. If the step ends before the separation, the "
	"particle waits (particle column impact_wait). The surface is taken as flat, other forces as zero. "
	"f_ID[1..3] is the mean force, impulse over time step; other outputs contain resolved contacts only: "
	"those that exist when the run begins, that last longer than 50 steps, or of particles that touch "
	"another one in the step. Impacts are counted by the fixes wear/.... Laws: hooke, hertz, "
	"hooke/stiffness, hertz/stiffness; tangential off, no_history, history. Walls must not rotate; rigid "
	"bodies, fixes that read resolved contacts (mesh/surface/stress, wear/archard), explicit Euler and "
	"heat "
	"are refused.",
	"Related: fix wall/gran/region, fix mesh/surface, fix surface/voxel, fix heat/gran, compute "
	"wall/gran/local.",
	NULL
};

TS_STYLE(fix, ts_style, ts_fix_wall_gran)
const struct ts_style ts_fix_wall_gran = {
	.name = "wall/gran",
	.kind = TS_KIND_FIX,
	.summary = "Rigid walls with a contact law: planes, cylinders, meshes and height fields",
	.doc = doc,
	.doc_more = doc_more,
	.example = "fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0\n"
		   "fix target all wall/gran model hertz tangential history primitive type 2 zplane 0.0 "
		   "impact exact\n"
		   "fix belt all wall/gran model hertz tangential history primitive type 1 zplane 0.0 shear "
		   "x 0.5\n"
		   "fix drum all wall/gran primitive type 2 zcylinder 0.05 0.0 0.0 temperature 373.15\n"
		   "fix lid all wall/gran hooke/history 200000.0 NULL 50.0 NULL 0.5 1 zplane 0.0 0.1 wiggle "
		   "z 0.001 0.02\n"
		   "fix side all wall/gran granular hertz/material 1e7 0.7 0.3 tangential mindlin NULL 1.0 "
		   "0.5 damping tsuji xplane 0.0 NULL\n"
		   "fix walls all wall/gran model hertz tangential history mesh n_meshes 2 meshes cad1 cad2\n"
		   "fix plate all wall/gran model hertz tangential history voxels rough",
	.args = args,
	.family = TS_FAMILY_WALL,
	.state_size = sizeof(struct wall),
	.archive = archive,
	.values = values,
	.gives = ts_wall_gives,
	.init = init,
	.saved = saved,
	.hook = { [TS_STAGE_POST_INTEGRATE] = ts_exact_carry,
		  [TS_STAGE_CHECK] = check,
		  [TS_STAGE_POST_BUILD] = post_build,
		  [TS_STAGE_POST_FORCE] = post_force },
	.defers = TS_DEFERS(POST_INTEGRATE),
	.plan = plan,
	.review = ts_coincide_review,
	.fini = fini,
};
