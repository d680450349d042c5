/* Check of the review: bonded structures that are not rigid (Maxwell's count). */
#include "review/internal.h"

#include "bond/bonds.h"
#include "math/unionfind.h"
#include "particle/identity.h"
#include "particle/prescribed.h"
#include "rigid/rigid.h"

#include "base/banned.h"

/* A set of particles connected by bonds; stored at the root particle of the set. */
struct cluster {
	size_t n, nfree, nbonds; /* particles, free ones, bonds with at least one free particle */
	bool rigid;		 /* some particles belong to a rigid body */
};

static bool is_free(const struct ts_particles *p, size_t i, uint32_t prescribed)
{
	return p->imass[i] > 0 && !(p->mask[i] & prescribed);
}

static void join_bonded(const struct tsim *sim, const struct ts_identities *map, int32_t *parent)
{
	const struct ts_bonds *bonds = sim->bonds;

	for (size_t b = 0; b < bonds->n; b++) {
		int32_t i = ts_identity_row(map, bonds->tag[b][0]),
			j = ts_identity_row(map, bonds->tag[b][1]);

		if (i >= 0 && j >= 0)
			ts_sets_join(parent, sim->particles->tag, (size_t)i, (size_t)j);
	}
}

static void count_members(const struct tsim *sim, const struct ts_identities *map, int32_t *parent,
			  struct cluster *c)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_bonds *bonds = sim->bonds;
	const uint32_t prescribed = ts_prescribed(sim);

	for (size_t i = 0; i < p->n; i++) {
		struct cluster *of = &c[ts_sets_root(parent, i)];

		of->n++;
		of->nfree += is_free(p, i, prescribed);
		of->rigid |= ts_rigid_member(p, i);
	}
	for (size_t b = 0; b < bonds->n; b++) {
		int32_t i = ts_identity_row(map, bonds->tag[b][0]),
			j = ts_identity_row(map, bonds->tag[b][1]);

		if (i >= 0 && j >= 0 &&
		    (is_free(p, (size_t)i, prescribed) || is_free(p, (size_t)j, prescribed)))
			c[ts_sets_root(parent, (size_t)i)].nbonds++;
	}
}

/* Number of bonds needed for rigidity in d dimensions, J. C. Maxwell, Phil. Mag. 27 (1864) 294:
 * d n - d (d + 1)/2 for n free particles, d n if some particles of the cluster are fixed. */
static size_t rigid_bond_count(const struct tsim *sim, const struct cluster *c)
{
	size_t d = (size_t)sim->dimension, all = d * c->nfree, whole = d * (d + 1) / 2;

	return c->nfree < c->n ? all : all > whole ? all - whole : 0;
}

/* Chains, trees and rings (no more bonds than particles) are flexible on purpose. */
static bool is_floppy(const struct tsim *sim, const struct cluster *c)
{
	return !c->rigid && c->nbonds > c->n && c->nbonds < rigid_bond_count(sim, c);
}

static enum ts_status report_clusters(struct tsim *sim, const struct cluster *c)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_instance *by = ts_sim_only(sim, TS_KIND_BOND);
	size_t most = 0, n = 0;

	for (size_t i = 0; i < p->n; i++) {
		if (!is_floppy(sim, &c[i]))
			continue;
		if (!n || c[i].n > c[most].n)
			most = i;
		n++;
	}
	if (!n)
		return TS_OK;
	return ts_review_report(sim, "bonds", by ? &by->where : NULL,
				"bonded structures that are not rigid: %zu; the largest has %zu particles "
				"(among them particle %d) and %zu bonds, but rigidity requires %zu: the "
				"bonds resist stretching only, not shear and bending of the structure; add "
				"bonds (larger distance of `create_bonds`), or use `review off bonds` for "
				"flexible structures",
				n, c[most].n, p->tag[most], c[most].nbonds, rigid_bond_count(sim, &c[most]));
}

/* No check after bonds have broken, since structures are then expected to lose rigidity, or with -check if
 * previous runs were not stepped, since bonds would be created at other positions. */
enum ts_status ts_review_bonds(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	struct ts_identities map;
	struct cluster *c;
	int32_t *parent;
	enum ts_status status;

	if (!sim->bonds->n || sim->bonds->transmits || sim->bonds->broken || sim->bonds->gone ||
	    sim->review.stale)
		return TS_OK;
	TS_TRY(ts_identities(sim, false, &map));
	parent = ts_alloc(p->n, sizeof *parent);
	c = ts_alloc(p->n, sizeof *c);
	status = parent && c ? TS_OK : ts_nomem(&sim->error);
	if (status == TS_OK) {
		ts_sets_start(parent, p->n);
		join_bonded(sim, &map, parent);
		count_members(sim, &map, parent, c);
		status = report_clusters(sim, c);
	}
	ts_free(parent);
	ts_free(c);
	return status;
}
