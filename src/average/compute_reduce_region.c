/* Compute: one number out of one for each particle in a region. */
#include "average/reduce.h"
#include "math/reduction.h"

#include "base/banned.h"

struct state {
	struct ts_reduce reduce;
};

static const struct ts_arg args[] = {
	TS_REGION("region", struct state, reduce.region, .flags = TS_POSITIONAL,
		  .help = "where particles count"),
	TS_REDUCE_ARGS(struct state),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_reduce_region)
const struct ts_style ts_compute_reduce_region = {
	.name = "reduce/region",
	.kind = TS_KIND_COMPUTE,
	.summary = "One number out of one for each particle in a region",
	.doc = "As compute reduce, over the particles of the group that are in the region now.",
	.example = "compute fast all reduce/region top max vx vy vz",
	.args = args,
	.state_size = sizeof(struct state),
	.values = ts_reduce_values,
	.init = ts_reduce_init,
	.fini = ts_reduce_fini,
};
