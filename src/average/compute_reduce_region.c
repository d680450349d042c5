/* Compute: reduces a value of each particle in a region to one number. */
#include "average/reduce.h"
#include "math/reduction.h"

#include "base/banned.h"

struct state {
	struct ts_reduce reduce;
};

static const struct ts_arg args[] = {
	TS_REGION("region", struct state, reduce.region, .flags = TS_POSITIONAL,
		  .help = "particles outside are excluded"),
	TS_REDUCE_ARGS(struct state),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_reduce_region)
const struct ts_style ts_compute_reduce_region = {
	.name = "reduce/region",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Sum, minimum, maximum or mean of per-particle values in a region",
	.doc = "As compute reduce, over the particles of the group that are in the region at the time of "
	       "evaluation.",
	.example = "compute fast all reduce/region top max vx vy vz",
	.args = args,
	.state_size = sizeof(struct state),
	.values = ts_reduce_values,
	.width = ts_reduce_width,
	.init = ts_reduce_init,
	.fini = ts_reduce_fini,
};
