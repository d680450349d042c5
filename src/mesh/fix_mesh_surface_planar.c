/* Fix mesh/surface/planar: a flat surface of triangles. */
#include "mesh/mesh_load.h"
#include "mesh/mesh_motion.h"
#include "mesh/mesh_style.h"

#include "base/banned.h"

struct state {
	struct ts_mesh_surface surface;
	struct ts_mesh_words words;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_mesh *m = &s->surface.mesh;
	size_t bend;

	TS_TRY(ts_mesh_surface_init(self, sim, &s->words));
	if (ts_mesh_planar(m, &bend))
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &self->where,
		       "mesh %s is not planar: it bends at the edge of triangle %zu that begins at (%g, %g, "
		       "%g); if it should not, take a larger `curvature`, else fix mesh/surface",
		       self->id, bend / 3 + 1, m->x[bend / 3][bend % 3][0], m->x[bend / 3][bend % 3][1],
		       m->x[bend / 3][bend % 3][2]);
}

static const struct ts_arg args[] = {
	TS_MESH_ARGS(struct state, words, surface),
	TS_ARGS_END,
};

static const struct ts_arg_group groups[] = {
	TS_MESH_GROUPS,
	{ .words = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_mesh_surface_planar)
const struct ts_style ts_fix_mesh_surface_planar = {
	.name = "mesh/surface/planar",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS | TS_RANKS_ROWLESS,
	.summary = "A flat surface of triangles from a file or of given sizes, for walls and insertion faces",
	.doc = "The same as fix mesh/surface, but the mesh is refused if the planes of two triangles that "
	       "share an edge include an angle larger than `curvature`.",
	.example = "fix inlet all mesh/surface/planar file inlet.stl type 1 scale 0.001\n"
		   "fix face all mesh/surface/planar primitive disk radius 0.02 base 0 0 0.1 type 1",
	.args = args,
	.groups = groups,
	.family = TS_FAMILY_MESH,
	.state_size = sizeof(struct state),
	.archive = ts_mesh_surface_archive,
	.fingerprint = ts_mesh_surface_fingerprint,
	.extent = ts_mesh_surface_extent,
	.init = init,
	.hook = { [TS_STAGE_POST_BUILD] = ts_mesh_surface_post_build },
	.plan = ts_mesh_surface_plan,
	.fini = ts_mesh_surface_fini,
};
