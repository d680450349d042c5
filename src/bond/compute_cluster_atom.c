/* Computes: which cluster, or aggregate, each particle belongs to. */
#include "bond/clusters.h"

#include "base/banned.h"

struct state {
	double cutoff;
};

static enum ts_status find(struct ts_instance *self, const struct tsim *sim, bool bonds, struct ts_table *out)
{
	const struct state *s = self->state;

	return ts_clusters_find(sim, self->group, s->cutoff, bonds, true, out);
}

static enum ts_status eval_cluster(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	return find(self, sim, false, out);
}

static enum ts_status eval_aggregate(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	return find(self, sim, true, out);
}

static const struct ts_value clusters[] = {
	{ "cluster", "", "smallest id of its cluster; 0 outside the group", TS_PERATOM, 1, NULL,
	  eval_cluster },
	{ .name = NULL },
};

static const struct ts_value aggregates[] = {
	{ "cluster", "", "smallest id of its aggregate; 0 outside the group", TS_PERATOM, 1, NULL,
	  eval_aggregate },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REAL("cutoff", struct state, cutoff, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.unit = "length", .help = "distance of centres within which particles belong together"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_cluster_atom)
const struct ts_style ts_compute_cluster_atom = {
	.name = "cluster/atom",
	.kind = TS_KIND_COMPUTE,
	.summary = "Which cluster each particle belongs to",
	.doc = "Particles of the group whose centres are nearer than the cutoff belong to one cluster, and "
	       "so on from one\nto the next; periodic images count. A cluster is known by the smallest id in "
	       "it; particles outside the\ngroup have 0.",
	.example = "compute piece all cluster/atom 0.0105",
	.args = args,
	.state_size = sizeof(struct state),
	.values = clusters,
};

TS_STYLE(compute, ts_style, ts_compute_aggregate_atom)
const struct ts_style ts_compute_aggregate_atom = {
	.name = "aggregate/atom",
	.kind = TS_KIND_COMPUTE,
	.summary = "Which aggregate each particle belongs to",
	.doc = "As compute cluster/atom, but particles that are bonded belong together too, however far "
	       "apart they are. "
	       "An\naggregate is known by the smallest id in it; particles outside the group have 0.",
	.example = "compute piece all aggregate/atom 0.0105",
	.args = args,
	.state_size = sizeof(struct state),
	.values = aggregates,
};
