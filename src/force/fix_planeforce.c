/* Fix planeforce: keeps only the force component in a plane. */
#include "force/force_filter.h"
#include "force/restraint.h"

#include "base/banned.h"

static enum ts_status project_forces(struct ts_instance *self, struct tsim *sim)
{
	ts_force_filter_apply(self, sim, 0, 1);
	return TS_OK;
}

static void project_force(const struct ts_instance *self, const struct tsim *sim, size_t i, double f[3])
{
	(void)sim;
	(void)i;
	ts_force_filter_one(self, 0, 1, f);
}

static const struct ts_restraint restraint = { NULL, project_force };

static const struct ts_arg args[] = {
	TS_VEC3("direction", struct ts_force_filter, direction, .flags = TS_POSITIONAL,
		.help = "normal of the plane; any length"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_planeforce)
const struct ts_style ts_fix_planeforce = {
	.name = "planeforce",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN,
	.summary = "keeps only the component of the force in a plane",
	.doc = "Removes the force component normal to the plane from each particle of the group, f = f - (f "
	       ". e) e with the unit normal e. Particles that start at rest then move in planes. Define this "
	       "fix after the fixes that add forces.",
	.example = "fix table all planeforce 0 0 1",
	.args = args,
	.state_size = sizeof(struct ts_force_filter),
	.init = ts_force_filter_init,
	.hook[TS_STAGE_POST_FORCE] = project_forces,
	.defers = TS_DEFERS(POST_FORCE),
	.restraint = &restraint,
};
