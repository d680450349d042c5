/* Fix wall/gran/region: the surface of a region is a wall. */
#include "core/sim.h"
#include "wall/region_wall.h"
#include "wall/wall_coincide.h"
#include "wall/wall_inserted.h"
#include "wall/wall_law.h"

#include "base/banned.h"

struct wall {
	struct ts_wall wall;
	struct ts_wall_law law;
	struct ts_region_wall region;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct wall *w = self->state;

	TS_TRY(ts_wall_law_choose(self, sim, &w->law, &w->wall));
	TS_TRY(ts_wall_find(self, sim, &ts_region_wall_shape, &w->region));
	return ts_wall_init(self, sim);
}

static enum ts_status post_build(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;

	if (!ts_wall_has_law(w, sim))
		return TS_OK; /* refused by the plan */
	TS_TRY(ts_wall_make_laws(self, sim));
	ts_wall_force(w);
	TS_TRY(w->shape->list(self, sim));
	return ts_wall_look_at_inserted(self, sim);
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;

	ts_wall_start(w, sim);
	return w->shape->enqueue(self, sim);
}

static const struct ts_arg args[] = {
	TS_GRANULAR_ARGS(struct wall, wall.words),
	TS_WALL_LAW_ARGS(struct wall, law),
	TS_REGION("region", struct wall, region.region, .help = "ID of the region whose surface is the wall"),
	TS_INT("type", struct wall, wall.type, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
	       .help = "with `model` or the law of the pair style: particle type whose material the wall "
		       "has"),
	TS_WALL_ARGS(struct wall, wall),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	TS_WALL_FORCE_VALUE,
	TS_WALL_CONTACTS_VALUE,
	{ .name = NULL },
};

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	TS_TRY(ts_region_wall_shape.archive(a, &((struct wall *)self->state)->region));
	return ts_wall_archive(self, sim, a);
}

static void fini(struct ts_instance *self)
{
	ts_region_wall_shape.release(&((struct wall *)self->state)->region);
	ts_wall_fini(self);
}

static const char doc[] =
	"Particles of the group interact with the surface of a region: a block, cone, cylinder, plane or "
	"sphere, or a union or intersection of such. They interact with the side that the region defines: "
	"`side in` keeps them inside, `side out` outside; a particle whose centre is on the other side feels "
	"no force, and one whose centre lies in the surface itself stops the run. If faces of the region are "
	"`open`, the other faces act from both sides.\n\n"
	"A particle inside has a contact with each face in range (three in a corner of a block), a particle "
	"outside one contact, at the nearest point of the surface. The surface of a union or intersection "
	"consists of the parts of its members' faces that bound the whole. Where faces of two members "
	"coincide neither counts: let one member reach a little farther.\n\n"
	"The contact laws are those of fix wall/gran. With the law of Hertz and those that depend on the "
	"contact area the curvature of the surface enters by the effective radius\n\n"
	"  R* = R/(1 + kappa R),\n\n"
	"kappa being the mean curvature of the surface, > 0 where it is convex towards the particle: 1/R_s "
	"for a sphere, 1/(2 R_c) for a cylinder and a cone. (LAMMPS takes the outer side of a cone as "
	"concave, too, and the outer side of a cylinder with open faces as flat.)\n\n"
	"If variables move or rotate the region, its surface moves with it. The surface velocity is the "
	"change of the variables since the step before, divided by the time step. (In LAMMPS the length of "
	"the axis of `rotate` is a factor of this velocity; here it has no effect.) Either a union or "
	"intersection moves, or its members do; LAMMPS leaves out the velocity of the members. Variables in "
	"place of numbers of the shape contribute nothing to the surface velocity, as in LAMMPS: a change of "
	"the radius, and also a centre or an axis that is a variable. A centre that moves is to be given by "
	"`move`, if its velocity matters in contacts. A surface that moves by more than the radius of a "
	"particle near it in one step stops the run (doc/stability.md).\n\n"
	"Unlike a mesh, a region has no images across periodic faces: a surface that reaches such a face "
	"ends there.\n\n"
	"Related: fix wall/gran, region, compute wall/gran/local.";

static const struct ts_arg_group groups[] = {
	{ NULL, "region type" }, TS_WALL_GROUP, TS_GRANULAR_GROUPS, TS_WALL_LAW_GROUP, { .words = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_wall_gran_region)
const struct ts_style ts_fix_wall_gran_region = {
	.name = "wall/gran/region",
	.kind = TS_KIND_FIX,
	.summary = "The surface of a region is a rigid wall with a contact law",
	.doc = doc,
	.example =
		"fix hopper all wall/gran/region hertz/history 200000.0 NULL 50.0 NULL 0.5 1 region funnel\n"
		"fix drum all wall/gran/region granular hertz/material 1e7 0.7 0.3 tangential mindlin NULL "
		"1.0 0.5 damping tsuji region tube\n"
		"fix bowl all wall/gran/region model hertz tangential history type 1 region cup",
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
	.hook = { [TS_STAGE_POST_BUILD] = post_build, [TS_STAGE_POST_FORCE] = post_force },
	.plan = ts_wall_plan,
	.review = ts_coincide_review,
	.fini = fini,
};
