/* Fix surface/impacts: impacts of particles on the elements of a surface, without a law of wear. */
#include "wear/wear.h"

#include "base/banned.h"

struct state {
	struct ts_wear wear;
};

static const struct ts_wear_law nothing_is_removed = { 0 };

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	return ts_wear_find_surface(self, sim, &nothing_is_removed);
}

static const struct ts_arg args[] = {
	TS_WEAR_SURFACE_ARG(struct state, wear),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_surface_impacts)
const struct ts_style ts_fix_surface_impacts = {
	.name = "surface/impacts",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "number, speed, angle, energy and force of the impacts on the elements of a surface",
	.doc = "Counts the impacts of the particles of the group on each element of a surface, with the "
	       "columns of the fixes wear/LAW, but without a law of wear and its volumes." TS_WEAR_IMPACT_DOC
	       "\n\n" TS_WEAR_ELEMENTS_DOC
	       "f_ID[1..10] are those of each element, f_ID is the number of impacts on the whole surface, "
	       "and f_ID[1..4] are its totals elsewhere.\n\n"
	       "Related: fix wear/finnie, fix surface/heat, fix mesh/surface, fix surface/voxel, fix "
	       "wall/gran.",
	.example = "fix chute all mesh/surface file chute.stl type 2\n"
		   "fix walls all wall/gran model hertz tangential history mesh n_meshes 1 meshes chute\n"
		   "fix hits all surface/impacts surface chute\n"
		   "dump hits all mesh/vtk 1000 post/chute*.vtk f_hits[1] f_hits[2] f_hits[3] chute",
	.args = args,
	.state_size = sizeof(struct state),
	.surface = ts_wear_surface,
	.values = ts_wear_impact_values,
	.archive = ts_wear_archive,
	.plan = ts_wear_plan,
	.observes = TS_OBSERVES_IMPACTS,
	.init = init,
	.late = { [TS_LATE_CONTACTS] = ts_wear_step },
	.fini = ts_wear_fini,
};
