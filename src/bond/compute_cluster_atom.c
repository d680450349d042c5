/* Computes: cluster, and aggregate, of each particle. */
#include "bond/clusters.h"

#include "base/banned.h"

struct state {
	double cutoff;
};

static enum ts_status find_clusters(struct ts_instance *self, const struct tsim *sim, bool bonds,
				    struct ts_table *out)
{
	const struct state *s = self->state;

	return ts_clusters_find(sim, self->group, s->cutoff, bonds, true, out);
}

static enum ts_status eval_cluster(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	return find_clusters(self, sim, false, out);
}

static enum ts_status eval_aggregate(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	return find_clusters(self, sim, true, out);
}

static const struct ts_value clusters[] = {
	{ "cluster", "", "smallest ID of its cluster; 0 outside the group", TS_PERATOM, 1, NULL,
	  eval_cluster },
	{ .name = NULL },
};

static const struct ts_value aggregates[] = {
	{ "cluster", "", "smallest ID of its aggregate; 0 outside the group", TS_PERATOM, 1, NULL,
	  eval_aggregate },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REAL("cutoff", struct state, cutoff, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.unit = "length", .help = "distance of the centres below which two particles are connected"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_cluster_atom)
const struct ts_style ts_compute_cluster_atom = {
	.name = "cluster/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "cluster ID of each particle",
	.doc = "Two particles of the group are connected if the distance of their centres is less than the "
	       "cutoff, periodic images included. A cluster is a set of particles that are connected "
	       "directly or through others. Its ID is the smallest particle ID in it; particles outside the "
	       "group have 0.",
	.example = "compute piece all cluster/atom 0.0105",
	.args = args,
	.state_size = sizeof(struct state),
	.values = clusters,
};

TS_STYLE(compute, ts_style, ts_compute_aggregate_atom)
const struct ts_style ts_compute_aggregate_atom = {
	.name = "aggregate/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "aggregate ID of each particle",
	.doc = "Like compute cluster/atom, but bonded particles are connected as well, at any distance. The "
	       "ID of an aggregate is the smallest particle ID in it; particles outside the group have 0.",
	.example = "compute piece all aggregate/atom 0.0105",
	.args = args,
	.state_size = sizeof(struct state),
	.values = aggregates,
};
