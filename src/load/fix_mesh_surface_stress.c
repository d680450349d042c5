/* Fix mesh/surface/stress: a surface of triangles that sums the load of particles on it. */
#include "mesh/mesh_load.h"
#include "mesh/mesh_style.h"
#include "load/mesh_stress.h"

#include "base/banned.h"

struct state {
	struct ts_mesh_surface surface;
	struct ts_mesh_words words;
	struct ts_mesh_stress stress;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_mesh_surface_init(self, sim, &s->words));
	return ts_mesh_stress_init(self, sim, &s->surface, &s->stress);
}

static const struct ts_arg args[] = {
	TS_MESH_ARGS(struct state, words, surface),
	TS_MESH_STRESS_ARGS(struct state, stress),
	TS_ARGS_END,
};

static const char *const names[] = { TS_MESH_STRESS_NAMES };

static const struct ts_value values[] = {
	{ "stress", "force, torque, length",
	  "force on the mesh and torque about the reference point in the last step, and that point",
	  TS_VECTOR, 9, names, ts_mesh_stress_eval },
	TS_MESH_STRESS_TRIANGLES,
	{ .name = NULL },
};

static const struct ts_arg_group groups[] = {
	TS_MESH_STRESS_GROUP,
	TS_MESH_GROUPS,
	{ .words = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_mesh_surface_stress)
const struct ts_style ts_fix_mesh_surface_stress = {
	.name = "mesh/surface/stress",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.join = ts_mesh_stress_join,
	.summary = "A triangle mesh with the force, torque, stresses and wear due to particles",
	.purpose = "As fix mesh/surface, for parts whose load is wanted: the torque of a drum, the weight on "
		   "a tray, pressure and wear on each triangle.",
	.doc = "A mesh as with fix mesh/surface. In addition, the forces that particles exert on it are "
	       "summed: f_ID[1..3] is the force on the mesh, f_ID[4..6] the torque about reference_point, "
	       "the sum of (p - reference_point) x F over the contact points p, f_ID[7..9] the present "
	       "position of reference_point, which moves with the mesh. All are those of the last complete "
	       "step, 0 before the first one. The keywords scale, move and rotate do not change "
	       "reference_point.\n\n"
	       "For each triangle of area A with the unit normal n and the force F, dump mesh/vtk writes the "
	       "normal stress |F.n|/A, the shear stress |F - (F.n) n|/A, and F/A.\n\n"
	       "With `wear finnie` each contact that does not separate increases the worn depth of its "
	       "triangle in a step by\n\n"
	       "  2 k v F f(g) h / A,  f = cos^2 g / 3 for tan g > 1/3, else sin 2g - 3 sin^2 g,\n\n"
	       "v being the velocity of the particle relative to the surface, g the angle between this "
	       "velocity and the surface, F the magnitude of the contact force, h the time step and k the "
	       "property k_finnie of both types.\n\n"
	       "With `impact exact` of fix wall/gran an impact counts as a whole in the step of the touch: "
	       "force and torque are their impulses over h, and the wear is the integral over the impact.\n\n"
	       "Related: fix mesh/surface, fix wall/gran, fix mesh/surface/stress/servo, fix move/mesh/free, "
	       "dump mesh/vtk.",
	.cite = "I. Finnie, Wear 3 (1960) 87",
	.example =
		"fix k all property/global k_finnie peratomtypepair 1 1e-9\n"
		"fix chute all mesh/surface/stress file chute.stl type 1 reference_point 0 0 0.1 wear finnie",
	.args = args,
	.groups = groups,
	.family = TS_FAMILY_MESH,
	.state_size = sizeof(struct state),
	.archive = ts_mesh_stress_archive,
	.fingerprint = ts_mesh_surface_fingerprint,
	.extent = ts_mesh_surface_extent,
	.values = values,
	.surface = ts_mesh_stress_surface,
	.observes = TS_OBSERVES_CONTACTS | TS_OBSERVES_BRIEF,
	.init = init,
	.late = { [TS_LATE_CONTACTS] = ts_mesh_stress_sum },
	.hook = { [TS_STAGE_POST_BUILD] = ts_mesh_stress_post_build,
		  [TS_STAGE_FINAL_INTEGRATE] = ts_mesh_stress_settle },
	.plan = ts_mesh_surface_plan,
	.fini = ts_mesh_stress_fini,
};
