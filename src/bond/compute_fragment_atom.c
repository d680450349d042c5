/* Compute: which fragment each particle belongs to. */
#include "bond/clusters.h"

#include "base/banned.h"

struct state {
	bool single;
};

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	return ts_clusters_find(sim, self->group, 0, true, s->single, out);
}

static const struct ts_value values[] = {
	{ "cluster", "", "smallest id of its fragment, or 0", TS_PERATOM, 1, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_BOOL("single", struct state, single, .fallback = "no",
		.help = "whether a particle without bonds is a fragment"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_fragment_atom)
const struct ts_style ts_compute_fragment_atom = {
	.name = "fragment/atom",
	.kind = TS_KIND_COMPUTE,
	.summary = "Which fragment each particle belongs to",
	.doc = "Particles of the group that are bonded belong to one fragment, and so on from one to the "
	       "next. A fragment is\nknown by the smallest id in it; particles outside the group have 0, and "
	       "those without bonds too unless\n`single yes`.",
	.example = "compute piece rock fragment/atom single yes",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
};
