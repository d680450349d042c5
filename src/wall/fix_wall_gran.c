#include "impact/exact_impacts.h"
#include "impact/impacts.h"
#include "math/vec3.h"
#include "wall/mesh_wall.h"
#include "wall/primitive_wall.h"
#include "wall/shared_contacts.h"
#include "wall/voxel_wall.h"
#include "wall/wall_coincide.h"
#include "wall/wall_inserted.h"
#include "wall/wall_law.h"

#include <math.h>

#include "base/banned.h"

struct wall {
	struct ts_wall wall;
	bool primitive_word;
	struct ts_wall_law law;
	struct ts_primitive_wall primitive;
	struct ts_mesh_wall mesh;
	struct ts_voxel_wall voxel;
	int impact; /* EXACT: `impact exact` */
};

enum { EXACT = 1 };
static const char *const impacts[] = { "resolved", "exact", NULL };

/* The shapes that a wall may have, and where their states are. */
static const struct {
	const struct ts_wall_shape *shape;
	size_t offset;
} shapes[] = {
	{ &ts_primitive_wall_shape, offsetof(struct wall, primitive) },
	{ &ts_mesh_wall_shape, offsetof(struct wall, mesh) },
	{ &ts_voxel_wall_shape, offsetof(struct wall, voxel) },
};
enum { PRIMITIVE, SHAPES = sizeof shapes / sizeof *shapes };

static void *geometry_of(struct ts_instance *self, int shape)
{
	return (char *)self->state + shapes[shape].offset;
}

/* ---- arguments ---- */

/* The one shape that the line gives. */
static enum ts_status choose_shape(struct ts_instance *self, struct tsim *sim, int *shape)
{
	int given[SHAPES], sum = 0;

	for (int k = 0; k < SHAPES; k++) {
		given[k] = shapes[k].shape->given(geometry_of(self, k));
		sum += given[k];
		*shape = given[k] ? k : *shape;
	}
	if (sum == 1)
		return TS_OK;
	if (sum > given[PRIMITIVE])
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix wall/gran: a wall is a mesh, a height field or a primitive, one of them");
	return ts_fail(&sim->error, TS_SYNTAX, &self->where,
		       "fix wall/gran: expected one of xplane, yplane, zplane, xcylinder, ycylinder, "
		       "zcylinder, found %d of them%s",
		       sum, sum ? "" : "; or `mesh n_meshes 1 meshes ID`, or `voxels ID`");
}

/* Of meshes and height fields: what moves and heats their surfaces is said elsewhere. */
static enum ts_status refuse_words_of_primitives(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_primitive_wall *w = &((const struct wall *)self->state)->primitive;
	const struct {
		const char *word, *instead;
		bool given;
	} words[] = {
		{ "shear", "surface_vel in its own fix", w->shear_words.n > 0 },
		{ "wiggle", "fix move/mesh wiggle", w->wiggle_words.n > 0 },
		{ "velocity", "surface_vel in its own fix", ts_norm(w->velocity) > 0 },
		{ "temperature", "temperature in its own fix", !isnan(w->temperature) },
	};

	for (size_t k = 0; k < sizeof words / sizeof *words; k++)
		if (words[k].given)
			return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, words[k].word),
				       "fix wall/gran: `%s` is for planes and cylinders; a mesh has %s",
				       words[k].word, words[k].instead);
	return TS_OK;
}

static enum ts_status init_exact(struct ts_instance *self, struct tsim *sim)
{
	const struct wall *w = self->state;
	const struct ts_wall_shape *shape = w->wall.shape;
	const char *why = shape->not_exact ? shape->not_exact(&w->wall) : NULL;

	if (w->impact != EXACT)
		return TS_OK;
	if (why)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "impact"),
			       "fix wall/gran impact exact: %s", why);
	return ts_exact_init(self, sim, shape->exact, w->wall.geometry);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;
	int shape = PRIMITIVE;

	TS_TRY(choose_shape(self, sim, &shape));
	if (shape != PRIMITIVE)
		TS_TRY(refuse_words_of_primitives(self, sim));
	TS_TRY(ts_wall_law_choose(self, sim, &w->law, &w->wall));
	TS_TRY(ts_wall_find(self, sim, shapes[shape].shape, geometry_of(self, shape)));
	TS_TRY(init_exact(self, sim));
	return ts_wall_init(self, sim);
}

/* ---- stages ---- */

static enum ts_status post_build(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;

	if (!ts_wall_has_law(w, sim))
		return TS_OK; /* refused by the plan */
	TS_TRY(ts_wall_make_laws(self, sim));
	TS_TRY(ts_surface_contacts_find_observers(sim, w));
	ts_wall_force(w);
	TS_TRY(w->shape->list(self, sim));
	TS_TRY(ts_wall_look_at_inserted(self, sim));
	return ts_impacts_prepare(self, sim);
}

static enum ts_status check(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_wall *w = self->state;

	sim->run.rebuild |= w->shape->has_moved(w, sim);
	return w->exact ? TS_OK /* also finds what it passes */ : w->shape->check_displacement(self, sim);
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;

	ts_wall_start(w, sim);
	TS_TRY(w->shape->enqueue(self, sim));
	ts_exact_add_force(w, sim);
	TS_TRY(ts_surface_contacts_collect(sim, w));
	return ts_impacts_update(sim, w);
}

static bool moves_by_time(const struct ts_instance *self)
{
	const struct ts_primitive_wall *w = ts_primitive_wall_of(self->state);

	return w && w->wiggle_words.n;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	TS_TRY(ts_wall_plan(self, sim, report));
	ts_shared_contacts_plan(sim, self->state, report);
	return ((const struct ts_wall *)self->state)->exact ? ts_exact_plan(self, sim, report) : TS_OK;
}

/* Of all shapes: a line that has been refused may have given several. */
static void fini(struct ts_instance *self)
{
	struct ts_wall *w = self->state;

	for (int k = 0; k < SHAPES; k++)
		if (shapes[k].shape->release)
			shapes[k].shape->release(geometry_of(self, k));
	ts_impacts_free(w->impacts);
	ts_exact_fini(w);
	ts_wall_fini(self);
}

/* Of all shapes, as older restart files have it. */
static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_wall *w = self->state;

	for (int k = 0; k < SHAPES; k++)
		if (shapes[k].shape->archive)
			TS_TRY(shapes[k].shape->archive(a, geometry_of(self, k)));
	TS_TRY(ts_exact_archive(a, sim, w));
	TS_TRY(ts_wall_archive(self, sim, a));
	return ts_impacts_archive(a, sim, w);
}

static const struct ts_arg args[] = {
	TS_GRANULAR_ARGS(struct wall, wall.words),
	TS_WALL_LAW_ARGS(struct wall, law),
	TS_FLAG("primitive", struct wall, primitive_word, .help = "the wall is a plane or cylinder"),
	TS_INT("type", struct wall, wall.type, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
	       .help = "primitive: particle type whose material the wall has"),
	TS_MESH_WALL_ARGS(struct wall, mesh),
	TS_VOXEL_WALL_ARGS(struct wall, voxel),
	TS_PRIMITIVE_WALL_ARGS(struct wall, primitive),
	TS_ENUM("impact", struct wall, impact, impacts, .flags = TS_STATEFUL, .fallback = "resolved",
		.help = "resolved: contacts are resolved by time steps; exact: a particle that hits the wall "
			"alone is carried through the whole impact in one step"),
	TS_WALL_ARGS(struct wall, wall),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	TS_WALL_FORCE_VALUE,
	TS_WALL_CONTACTS_VALUE,
	{ .name = NULL },
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
	"The centre of a cylinder is given along the next two axes in cyclic order: xcylinder y z, ycylinder "
	"z x, zcylinder x y.\n\n"
	"`shear DIM V`: the surface moves with the velocity V along DIM, but the wall stays in place. If DIM "
	"is not the axis of a cylinder, the cylinder rotates about its axis. As in LIGGGHTS, V is then the "
	"angular velocity (radian/time), and a point of the surface at d from the axis of direction a has "
	"the velocity V a x d. At a contact d is taken to the centre of the particle, as in LIGGGHTS: inside "
	"a cylinder of radius R a particle of radius r meets the speed V (R - r), outside V (R + r), and "
	"sliding distances, work of friction and wear have the factor 1 - r/R or 1 + r/R. A turning mesh "
	"(fix move/mesh) has the velocity at the contact point. (LIGGGHTS interchanges two components for "
	"ycylinder, as `legacy yes` does.) With the laws of LAMMPS, V is the speed of the surface, clockwise "
	"as seen from the tip of the axis. (LAMMPS' program adds V along DIM; here nothing is added.)\n\n"
	"`wiggle DIM A T`: the displacement is A (1 - cos(2 pi t/T)), t being the time since the definition "
	"of the fix. Along the surface only the velocity has an effect.\n\n"
	"`temperature T`: with fix heat/gran, each touching particle of temperature T_i receives the heat "
	"flow\n\n"
	"  Q = h (T - T_i),  h = 4 k k_wall/(k + k_wall) sqrt(A),\n\n"
	"k and k_wall being the conductivities. The contact area is A = pi (R^2 - r^2), r being the distance "
	"of the centre from the wall, or as `contact_area` says.\n\n"
	"`store_force yes` stores the force of the wall on each particle as f_force_ID[1] ... [3].\n\n"
	"A wall of meshes interacts with the particles of the groups of both this fix and the fix of the "
	"mesh, at faces, edges and corners and from both sides. See fix mesh/surface for the edges and "
	"corners that are active, and for the temperature of a mesh. A contact that moves from one triangle "
	"to a flat neighbour keeps its history. Laws that act beyond the touch (model jkr) do so on meshes "
	"as on planes: each point of the mesh that is nearest to the particle in all triangles that share it "
	"is one contact, which keeps its history when it moves across edges and corners, too. Edges of two "
	"meshes that lie on each other are two contacts, as in LIGGGHTS, with twice the force: what is one "
	"surface should be one mesh.\n\n"
	"Equations typeset, assumptions, order and limits: doc/theory-contact.md.";

static const char *const doc_more[] = {
	"`voxels ID` makes a wall of a height field, see fix surface/voxel. Particles of the groups of both "
	"fixes interact with it from outside; a particle whose centre gets into the solid stops the run. "
	"Each point of the surface that is nearer to the centre than all other points around it is one "
	"contact: on a top, a side, an edge or a corner of the columns. A contact that slides to another "
	"column keeps its history: a new contact continues the one that has ended in the same step, of "
	"several that with the nearest normal, if the angle between the normals is less than 8 degrees.",
	"`impact exact`: a particle that hits the wall alone is carried through the whole impact in one time "
	"step. From the first touch on its path the motion under the contact law is integrated until the "
	"surfaces separate; the free flight then continues. If the step ends before the separation, the "
	"particle waits (particle column impact_wait). The surface is taken as flat, other forces as zero. "
	"f_ID[1..3] is the mean force, impulse over time step; other outputs contain resolved contacts only: "
	"those that exist when the run begins, that last longer than 50 steps, of particles that touch "
	"another one in the step, or of rigid bodies (a warning says if they last less than 10 steps). The "
	"fixes wear/... count the impacts; wear/archard, wear/zhao/chang/contact and the load and wear of "
	"mesh/surface/stress are integrals over each impact, in the step of its touch, for the element "
	"touched first. Laws: hooke, hertz, hooke/stiffness, hooke/modulus, hertz/stiffness; tangential off, "
	"no_history, history. Walls must not rotate; fix mesh/surface/stress/servo, explicit Euler and heat "
	"are refused.",
	"Related: fix wall/gran/region, fix mesh/surface, fix surface/voxel, fix heat/gran, compute "
	"wall/gran/local.",
	NULL
};

static const struct ts_arg_group groups[] = {
	{ NULL, "primitive type xplane yplane zplane xcylinder ycylinder zcylinder mesh n_meshes meshes" },
	{ "Height fields", "voxels" },
	{ "Motion and temperature of the surface", "shear wiggle velocity temperature" },
	{ "Impacts", "impact" },
	TS_WALL_GROUP,
	TS_GRANULAR_GROUPS,
	TS_WALL_LAW_GROUP,
	{ .words = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_wall_gran)
const struct ts_style ts_fix_wall_gran = {
	.name = "wall/gran",
	.kind = TS_KIND_FIX,
	.summary = "Rigid walls with a contact law: planes, cylinders, meshes and height fields",
	.purpose = "Floors, hoppers, drums, belts, lids and whole machines that grains touch. Give one "
		   "contact law and one shape: a plane or cylinder (`primitive`), meshes (`mesh`), or a "
		   "height field (`voxels`).",
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
	.groups = groups,
	.family = TS_FAMILY_WALL,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS | TS_RANKS_REVIEW | TS_RANKS_ROWLESS,
	.join = ts_wall_join,
	.carrier = &ts_wall_carrier,
	.state_size = sizeof(struct wall),
	.archive = archive,
	.values = values,
	.gives = ts_wall_gives,
	.init = init,
	.hook = { [TS_STAGE_POST_INTEGRATE] = ts_exact_carry,
		  [TS_STAGE_CHECK] = check,
		  [TS_STAGE_POST_BUILD] = post_build,
		  [TS_STAGE_POST_FORCE] = post_force },
	.defers = TS_DEFERS(POST_INTEGRATE),
	.moves_by_time = moves_by_time,
	.plan = plan,
	.review = ts_coincide_review,
	.fini = fini,
};
