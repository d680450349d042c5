/* Compute: reduces a value of each particle to one number. */
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
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Sum, minimum, maximum or mean of per-particle or local values",
	.doc = "Reduces values to a single number, over the particles of the group or over all rows of a "
	       "local array (contacts, bonds): sum, minimum (min), maximum (max), mean (ave), sum and mean "
	       "of squares (sumsq, avesq), and the same of absolute values (sumabs, aveabs, minabs, maxabs); "
	       "std is the standard deviation sqrt(<(x - <x>)^2>), which LAMMPS does not have. c_ID is the "
	       "result of the first input, c_ID[k] that of the k-th. Sums are exact, rounded once, and do "
	       "not depend on the order. If there are no values, all results are 0.\n\n"
	       "With `replace m n` result m is the value of input m at the particle where input n is minimal "
	       "or maximal; if there are several such particles, at that of the smallest id.",
	.example = "compute fastest all reduce max vx vy vz\n"
		   "compute hits all reduce sum c_contacts\n"
		   "compute where all reduce max c_energy id replace 2 1",
	.args = args,
	.state_size = sizeof(struct state),
	.values = ts_reduce_values,
	.width = ts_reduce_width,
	.init = ts_reduce_init,
	.fini = ts_reduce_fini,
};
