/* Checks of the review: bonded structures that keep no shape. */
#include "review/checks.h"

#include "bond/bonds.h"
#include "math/unionfind.h"
#include "particle/identity.h"
#include "particle/prescribed.h"
#include "rigid/rigid.h"

#include "base/banned.h"

/* Particles that hang together by bonds; that of the root of the set is kept. */
struct cluster {
	size_t n, nfree, nbonds;
	bool rigid; /* some belong to a rigid body */
};

static bool is_free(const struct ts_particles *p, size_t i, uint32_t prescribed)
{
	return p->imass[i] > 0 && !(p->mask[i] & prescribed);
}

static void join(const struct tsim *sim, const struct ts_identities *map, int32_t *parent)
{
	const struct ts_bonds *bonds = sim->bonds;

	for (size_t b = 0; b < bonds->n; b++) {
		int32_t i = ts_contact_of(map, bonds->tag[b][0]), j = ts_contact_of(map, bonds->tag[b][1]);

		if (i >= 0 && j >= 0)
			ts_sets_join(parent, sim->particles->tag, (size_t)i, (size_t)j);
	}
}

static void count(const struct tsim *sim, const struct ts_identities *map, int32_t *parent, struct cluster *c)
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
		int32_t i = ts_contact_of(map, bonds->tag[b][0]), j = ts_contact_of(map, bonds->tag[b][1]);

		if (i >= 0 && j >= 0 &&
		    (is_free(p, (size_t)i, prescribed) || is_free(p, (size_t)j, prescribed)))
			c[ts_sets_root(parent, (size_t)i)].nbonds++;
	}
}

/* J. C. Maxwell, Phil. Mag. 27 (1864) 294: a frame of n joints needs d n - d (d + 1)/2 bars, one that is
 * held somewhere d for each free joint. */
static size_t needed(const struct tsim *sim, const struct cluster *c)
{
	size_t d = (size_t)sim->dimension, all = d * c->nfree, whole = d * (d + 1) / 2;

	return c->nfree < c->n ? all : all > whole ? all - whole : 0;
}

/* What hangs together like a chain, a tree or a ring is meant to be flexible. */
static bool is_floppy(const struct tsim *sim, const struct cluster *c)
{
	return !c->rigid && c->nbonds > c->n && c->nbonds < needed(sim, c);
}

static enum ts_status report(struct tsim *sim, const struct cluster *c)
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
	return ts_review_find(sim, "bonds", by ? &by->where : NULL,
			      "bonded structures that keep no shape: %zu, the largest of %zu particles "
			      "(particle %d is one) with %zu bonds, where %zu are needed: these bonds resist "
			      "stretching only, so that it shears and bends without resistance; bond "
			      "particles with more partners (a larger distance of `create_bonds`), or say "
			      "`review off bonds` if it is to be flexible",
			      n, c[most].n, p->tag[most], c[most].nbonds, needed(sim, &c[most]));
}

/* Where bonds have broken it is what the simulation is about; and where particles are not where they will
 * be (-check) other bonds would be made. */
enum ts_status ts_review_bonds(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	struct ts_identities map;
	struct cluster *c;
	int32_t *parent;
	enum ts_status status;

	if (!sim->bonds->n || sim->bonds->broken || sim->bonds->gone || sim->review.stale)
		return TS_OK;
	TS_TRY(ts_identities(sim, false, &map));
	parent = ts_alloc(p->n, sizeof *parent);
	c = ts_alloc(p->n, sizeof *c);
	status = parent && c ? TS_OK : ts_nomem(&sim->error);
	if (status == TS_OK) {
		ts_sets_start(parent, p->n);
		join(sim, &map, parent);
		count(sim, &map, parent, c);
		status = report(sim, c);
	}
	ts_free(parent);
	ts_free(c);
	return status;
}
