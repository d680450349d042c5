/* Compute: which aggregate each particle belongs to. */
#include "neigh/clusters.h"

#include "base/banned.h"

struct state {
	double cutoff;
};

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	return ts_clusters_find(sim, self->group, s->cutoff, true, true, out);
}

static const struct ts_value values[] = {
	{ "cluster", "", "smallest id of its aggregate; 0 outside the group",
	  TS_PERATOM, 1, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REAL("cutoff", struct state, cutoff, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.unit = "length", .help = "distance of centres within which particles belong together"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_aggregate_atom)
const struct ts_style ts_compute_aggregate_atom = {
	.name = "aggregate/atom",
	.kind = TS_KIND_COMPUTE,
	.summary = "Which aggregate each particle belongs to",
	.doc = "As compute cluster/atom, but particles that are bonded belong together too, however far apart they are. "
	       "An\naggregate is known by the smallest id in it; particles outside the group have 0.",
	.example = "compute piece all aggregate/atom 0.0105",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
};
