#include "bond/clusters.h"

#include "bond/bonds.h"
#include "box/domain.h"
#include "geom/pairs.h"
#include "math/unionfind.h"
#include "particle/identity.h"
#include "particle/particles.h"

#include "base/banned.h"

struct cluster_search {
	const struct ts_particles *p;
	int32_t *parent;
	unsigned char *bonded; /* has a bond, to whichever particle */
	int group;
};

static void join_pair(void *context, size_t i, size_t j, const double d[3])
{
	const struct cluster_search *t = context;

	(void)d;
	if (i < j && ts_in_group(t->p, i, t->group) && ts_in_group(t->p, j, t->group))
		ts_sets_join(t->parent, t->p->tag, i, j);
}

/* Partners are looked up by identity: the local indices of the bonds are those of the last rebuild. */
static enum ts_status join_bonds(struct tsim *sim, const struct cluster_search *t)
{
	const struct ts_bonds *bonds = sim->bonds;
	struct ts_identities map;

	TS_TRY(ts_identities(sim, false, &map));
	for (size_t b = 0; b < bonds->n; b++) {
		int32_t i = ts_identity_row(&map, bonds->tag[b][0]),
			j = ts_identity_row(&map, bonds->tag[b][1]);

		if (i >= 0)
			t->bonded[i] = 1;
		if (j >= 0)
			t->bonded[j] = 1;
		if (i >= 0 && j >= 0)
			join_pair((void *)(uintptr_t)t, i < j ? (size_t)i : (size_t)j,
				  i < j ? (size_t)j : (size_t)i, NULL);
	}
	return TS_OK;
}

static enum ts_status join_clusters(const struct tsim *sim, const struct cluster_search *t, double cutoff,
				    bool bonds)
{
	const struct ts_particles *p = sim->particles;

	ts_sets_start(t->parent, p->n);
	if (cutoff > 0)
		TS_TRY(ts_pairs_visit(&sim->domain->box, sim->dimension, (const double(*)[3])p->x, p->n,
				      cutoff, join_pair, (void *)(uintptr_t)t));
	/* the map of identities is scratch memory of the particles */
	return bonds ? join_bonds((struct tsim *)(uintptr_t)sim, t) : TS_OK;
}

enum ts_status ts_clusters_find(const struct tsim *sim, int group, double cutoff, bool bonds, bool alone,
				struct ts_table *out)
{
	const struct ts_particles *p = sim->particles;
	struct cluster_search cluster_search = { p, NULL, NULL, group };
	enum ts_status status;

	TS_TRY(ts_table_resize(out, p->n, 1));
	cluster_search.parent = ts_alloc(p->n, sizeof *cluster_search.parent);
	cluster_search.bonded = ts_alloc(p->n, sizeof *cluster_search.bonded);
	status = cluster_search.parent && cluster_search.bonded
			 ? join_clusters(sim, &cluster_search, cutoff, bonds)
			 : TS_NOMEM;
	for (size_t i = 0; i < p->n; i++)
		out->data[i] = 0;
	/* a root with a member is not isolated, nor is one that is bonded to a particle outside the group */
	for (size_t i = 0; status == TS_OK && i < p->n; i++) {
		size_t root = ts_sets_root(cluster_search.parent, i);

		if (!ts_in_group(p, i, group) || (root == i && !alone && !cluster_search.bonded[i]))
			continue;
		out->data[i] = out->data[root] = p->tag[root];
	}
	ts_free(cluster_search.parent);
	ts_free(cluster_search.bonded);
	return status;
}
