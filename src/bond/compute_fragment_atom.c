/* Compute: fragment of each particle. */
#include "bond/clusters.h"

#include "base/banned.h"

struct state {
	bool single;
};

static enum ts_status eval_fragments(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	return ts_clusters_find(sim, self->group, 0, true, s->single, out);
}

static const struct ts_value values[] = {
	{ "cluster", "", "smallest ID of its fragment, or 0", TS_PERATOM, 1, NULL, eval_fragments },
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
	.ranks = TS_RANKS_WHOLE,
	.summary = "fragment ID of each particle",
	.doc = "A fragment is a set of particles of the group that are connected by bonds, directly or "
	       "through others. Its ID is the smallest particle ID in it. Particles outside the group have "
	       "0, and so have particles without bonds unless `single yes`. A particle of the group whose "
	       "bonds all lead to particles outside it is a fragment of its own.",
	.example = "compute piece rock fragment/atom single yes",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
};
