#include "bond/bond_search.h"

#include <math.h>

#include "base/sort.h"
#include "bond/bond_force.h"
#include "bond/bond_reference.h"
#include "box/domain.h"
#include "geom/pointhash.h"
#include "neigh/coincide.h"
#include "neigh/neigh.h"
#include "particle/copies.h"
#include "particle/particles.h"

#include "base/banned.h"

/* One query: the partners of particle i. */
struct query {
	struct tsim *sim;
	const size_t *row; /* of the points of the hash */
	double reach;
	ts_bond_wanted_fn *wanted;
	const void *context;
	const struct ts_place *where;
	struct ts_bond_candidates *out;
	size_t i;
	enum ts_status status;
};

static enum ts_status consider_pair(struct query *q, size_t j)
{
	const struct ts_particles *p = q->sim->particles;
	size_t i = q->i;
	double d[3], distance;

	if (p->tag[j] <= p->tag[i]) {
		if (j < p->n || p->tag[j] == p->tag[i]) /* found from the other side, or itself */
			return TS_OK;
		i = j;
		j = q->i;
	}
	distance = ts_bond_separation(q->sim, i, j, d);
	if (!(distance < q->reach) || !q->wanted(q->context, q->sim, i, j, distance) ||
	    ts_bonds_has(q->sim->bonds, p->tag[i], p->tag[j]))
		return TS_OK;
	TS_TRY(ts_coincide_bond(q->sim, q->where, i, j, distance));
	if (TS_GROW(q->out->pair, q->out->capacity, q->out->n + 1) != TS_OK)
		return ts_nomem(&q->sim->error);
	q->out->pair[q->out->n++] =
		(struct ts_bond_candidate){ { p->tag[i], p->tag[j] }, { i, j }, distance };
	return TS_OK;
}

static bool visit(void *context, size_t k)
{
	struct query *q = context;

	q->status = consider_pair(q, q->row[k]);
	return q->status != TS_OK;
}

/* How far particles are outside of the box, length. */
static double excursion(const struct tsim *sim, const struct ts_pointhash *hash)
{
	const struct ts_box *box = &sim->domain->box;
	double most = 0;

	for (size_t k = 0; k < hash->n; k++)
		for (int c = 0; c < 3; c++)
			most = fmax(most, fmax(box->lo[c] - hash->x[k][c], hash->x[k][c] - box->hi[c]));
	return most;
}

static enum ts_status fill(struct tsim *sim, int group, double reach, struct ts_pointhash *hash, size_t *row)
{
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_pointhash_start(hash, reach));
	for (size_t i = 0; i < p->n + ts_copies(sim); i++) {
		if (!ts_in_group(p, i, group))
			continue;
		row[hash->n] = i;
		TS_TRY(ts_pointhash_add(hash, p->x[i]));
	}
	return TS_OK;
}

static enum ts_status find_partners(struct query *q, const struct ts_pointhash *hash)
{
	const struct ts_box *box = &q->sim->domain->box;
	double far = q->reach + excursion(q->sim, hash);

	for (size_t k = 0; k < hash->n && q->row[k] < q->sim->particles->n; k++) {
		q->i = q->row[k];
		for (int n = 0; n < 27; n++) {
			double image[3];

			if (ts_box_image(box, hash->x[k], n, far, image))
				ts_pointhash_visit(hash, image, q->reach, visit, q);
			TS_TRY(q->status);
		}
	}
	return TS_OK;
}

/* By identities: which bonds are created does not depend on the order of particles. In a small periodic box a pair is
 * found several times. */
static void sort_candidates(struct ts_bond_candidates *c)
{
	size_t kept = 0;

	ts_sort(c->pair, c->n, sizeof *c->pair, ts_compare_int32_pair);
	for (size_t k = 0; k < c->n; k++)
		if (!k || ts_compare_int32_pair(c->pair[k].tag, c->pair[k - 1].tag))
			c->pair[kept++] = c->pair[k];
	c->n = kept;
}

enum ts_status ts_bond_search(struct tsim *sim, int group, double reach, ts_bond_wanted_fn *wanted,
			      const void *context, const struct ts_place *where,
			      struct ts_bond_candidates *out)
{
	struct ts_pointhash hash = { 0 };
	size_t *row = ts_alloc(sim->particles->n + ts_copies(sim), sizeof *row);
	struct query q = { sim, row, reach, wanted, context, where, out, 0, TS_OK };
	enum ts_status status = row ? TS_OK : ts_nomem(&sim->error);

	if (status == TS_OK && fill(sim, group, reach, &hash, row) != TS_OK)
		status = ts_nomem(&sim->error);
	if (status == TS_OK)
		status = find_partners(&q, &hash);
	ts_pointhash_release(&hash);
	ts_free(row);
	if (status == TS_OK)
		sort_candidates(out);
	return status;
}

enum ts_status ts_bonds_add_pair(struct tsim *sim, const struct ts_bond_candidate *pair, int type)
{
	TS_TRY(ts_bonds_add(sim, pair->tag[0], pair->tag[1], type, pair->distance));
	sim->bonds->created -= pair->row[0] >= sim->particles->n;
	return TS_OK;
}

enum ts_status ts_bonds_added(struct tsim *sim)
{
	ts_bonds_sort(sim->bonds);
	TS_TRY(ts_bonds_allow(sim));
	TS_TRY(ts_bond_reference_complete(sim));
	sim->neigh->stale |= sim->neigh->skip_bonded;
	return ts_bonds_connect(sim);
}
