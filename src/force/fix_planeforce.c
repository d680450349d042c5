/* Fix planeforce: Lets particles feel only the force in a plane. */
#include "force/force_filter.h"
#include "force/restraint.h"

#include "base/banned.h"

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	ts_force_filter_apply(self, sim, 0, 1);
	return TS_OK;
}

static void leave(const struct ts_instance *self, const struct tsim *sim, size_t i, double f[3])
{
	(void)sim;
	(void)i;
	ts_force_filter_one(self, 0, 1, f);
}

static const struct ts_restraint restraint = { NULL, leave };

static const struct ts_arg args[] = {
	TS_VEC3("direction", struct ts_force_filter, direction, .flags = TS_POSITIONAL,
		.help = "normal of the plane; any length"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_planeforce)
const struct ts_style ts_fix_planeforce = {
	.name = "planeforce",
	.kind = TS_KIND_FIX,
	.summary = "Lets particles feel only the force in a plane",
	.doc = "f -= (f . e) e with the unit normal e: particles that start at rest move in planes.",
	.example = "fix table all planeforce 0 0 1",
	.args = args,
	.state_size = sizeof(struct ts_force_filter),
	.init = ts_force_filter_init,
	.hook[TS_STAGE_POST_FORCE] = post_force,
	.restraint = &restraint,
};
