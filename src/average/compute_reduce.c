/* Compute: one number out of one for each particle. */
#include "average/reduce.h"
#include "math/reduction.h"

#include "base/banned.h"

struct state {
	struct ts_reduce reduce;
};

static const struct ts_arg args[] = {
	TS_REDUCE_ARGS(struct state),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_reduce)
const struct ts_style ts_compute_reduce = {
	.name = "reduce",
	.kind = TS_KIND_COMPUTE,
	.summary = "One number out of one for each particle",
	.doc = "Over the particles of the group, or over all rows of a local table (contacts, bonds): sum, "
	       "least (min), largest\n(max), mean (ave), sum and mean of squares (sumsq, avesq), and the "
	       "same of absolute values (sumabs, aveabs,\nminabs, maxabs). c_ID is that of the first input, "
	       "c_ID[k] of the k-th. Sums are rounded once and do not\ndepend on the order. Of no values all "
	       "are 0. With `replace m n` number m is the value of input m where input\nn is least or "
	       "largest: of several such particles, at that of the smallest id.",
	.example = "compute fastest all reduce max vx vy vz\n"
		   "compute hits all reduce sum c_contacts\n"
		   "compute where all reduce max c_energy id replace 2 1",
	.args = args,
	.state_size = sizeof(struct state),
	.values = ts_reduce_values,
	.init = ts_reduce_init,
	.fini = ts_reduce_fini,
};
