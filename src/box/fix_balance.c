/* Fix balance: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	struct ts_words words;
};

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)self, (void)sim;
	out->data[0] = 1;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REST("words", struct state, words, .help = "no effect"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "imbalance", "", "always 1: one process has all particles", TS_SCALAR, 1, NULL, eval },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_balance)
const struct ts_style ts_fix_balance = {
	.name = "balance",
	.kind = TS_KIND_FIX,
	.summary = "Accepted for compatibility; has no effect",
	.doc = "In LAMMPS this fix adjusts the sub-domains of processes. tsim distributes the particles "
	       "evenly over its threads in each loop.",
	.example = "fix share all balance 1000 1.1 shift xy 10 1.1",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
};
