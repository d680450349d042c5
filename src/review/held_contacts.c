/* Check of the review: contacts of two held particles, which no contact law evaluates, where outputs read forces. */
#include <math.h>

#include "base/alloc.h"
#include "bond/bonds.h"
#include "box/domain.h"
#include "geom/pairs.h"
#include "neigh/neigh.h"
#include "review/internal.h"

#include "base/banned.h"

/* Held particles by a list of their own, so that a bed with few of them costs little. */
struct held {
	const struct tsim *sim;
	ts_excluded_fn *excluded;
	double (*x)[3];
	size_t *particle, n, held;
	size_t contacts, a, b; /* number, and the last one */
};

static enum ts_status collect(struct held *h)
{
	const struct ts_particles *p = h->sim->particles;

	for (size_t i = 0; i < p->n; i++)
		h->held += p->imass[i] > 0 ? 0 : 1;
	if (h->held < 2)
		return TS_OK;
	h->x = ts_alloc(h->held, sizeof *h->x);
	h->particle = ts_alloc(h->held, sizeof *h->particle);
	if (!h->x || !h->particle)
		return TS_NOMEM;
	for (size_t i = 0; i < p->n; i++) {
		if (p->imass[i] > 0)
			continue;
		for (int k = 0; k < 3; k++)
			h->x[h->n][k] = p->x[i][k];
		h->particle[h->n++] = i;
	}
	return TS_OK;
}

static void count_contact(void *context, size_t first, size_t second, const double d[3])
{
	struct held *h = context;
	const struct ts_particles *p = h->sim->particles;
	size_t i = h->particle[first], j = h->particle[second];
	double reach = p->radius[i] + p->radius[j];

	if (p->tag[i] >= p->tag[j] || !(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach) ||
	    (h->excluded && h->excluded(h->sim, i, j, d)) ||
	    ts_bonds_has(h->sim->bonds, p->tag[i], p->tag[j]))
		return;
	h->contacts++;
	h->a = i;
	h->b = j;
}

static enum ts_status count_contacts(struct held *h)
{
	const struct ts_particles *p = h->sim->particles;
	double most = 0;

	if (collect(h) != TS_OK)
		return TS_NOMEM;
	for (size_t k = 0; k < h->n; k++)
		most = fmax(most, p->radius[h->particle[k]]);
	if (!(most > 0))
		return TS_OK;
	return ts_pairs_visit(&h->sim->domain->box, h->sim->dimension, (const double(*)[3])h->x, h->n,
			      2 * most, count_contact, h);
}

enum ts_status ts_review_held_contacts(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	struct held h = { .sim = sim, .excluded = ts_neigh_excluded(sim) };
	enum ts_status status;

	if (!(sim->neigh->keep_forces || sim->run.shows_contacts) || !ts_sim_only(sim, TS_KIND_PAIR))
		return TS_OK;
	status = count_contacts(&h);
	ts_free(h.x);
	ts_free(h.particle);
	if (status != TS_OK)
		return ts_nomem(&sim->error);
	if (!h.contacts &&
	    !(sim->division && h.held)) /* it may touch one of another rank: all look for that */
		return TS_OK;
	return ts_review_report(sim, "held_contacts", NULL,
				"contacts of two particles that `fix freeze` or `fix move` holds: %zu, one "
				"of them of "
				"particles %d and %d at (%g %g %g); they are not evaluated, so pressures, "
				"stresses, "
				"energies and lists of contact forces leave them out (LIGGGHTS and LAMMPS "
				"count them)",
				h.contacts, p->tag[h.a], p->tag[h.b], p->x[h.a][0], p->x[h.a][1],
				p->x[h.a][2]);
}
