/* Fix lineforce: keeps only the force component along a line. */
#include "force/force_filter.h"
#include "force/restraint.h"

#include "base/banned.h"

static enum ts_status project_forces(struct ts_instance *self, struct tsim *sim)
{
	ts_force_filter_apply(self, sim, 1, 0);
	return TS_OK;
}

static void project_force(const struct ts_instance *self, const struct tsim *sim, size_t i, double f[3])
{
	(void)sim;
	(void)i;
	ts_force_filter_one(self, 1, 0, f);
}

static const struct ts_restraint restraint = { NULL, project_force };

static const struct ts_arg args[] = {
	TS_VEC3("direction", struct ts_force_filter, direction, .flags = TS_POSITIONAL,
		.help = "direction of the line; any length"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_lineforce)
const struct ts_style ts_fix_lineforce = {
	.name = "lineforce",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN,
	.summary = "keeps only the component of the force along a line",
	.doc = "Replaces the force on each particle of the group by its component along the line, f = (f . "
	       "e) e with the unit vector e of the direction. Particles that start at rest then move along "
	       "straight lines. Define this fix after the fixes that add forces.",
	.example = "fix rail all lineforce 0 1 1",
	.args = args,
	.state_size = sizeof(struct ts_force_filter),
	.init = ts_force_filter_init,
	.hook[TS_STAGE_POST_FORCE] = project_forces,
	.defers = TS_DEFERS(POST_FORCE),
	.restraint = &restraint,
};
