#include "neigh/overlaps.h"

#include "box/domain.h"
#include "math/vec3.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

#include "base/banned.h"

/* Whether the contact list has all pairs that overlap: not those of two immobile particles, nor pairs after a command has moved
 * particles, nor those of other ranks. */
static bool list_has_all(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_contact_list *list = &sim->neigh->contacts;

	if (!sim->run.inside || sim->division || sim->legacy || !sim->neigh->wanted || !list->pair ||
	    list->both_frozen || list->particles != p->n)
		return false;
	for (size_t i = 0; i < p->n; i++)
		if (p->imass[i] == 0)
			return false;
	return true;
}

static bool overlap(const struct ts_particles *p, size_t i, size_t j, const double d[3])
{
	double reach = p->radius[i] + p->radius[j];

	return ts_dot(d, d) <= reach * reach;
}

/* A pair across a periodic face is listed twice, with a ghost as j. */
static void visit_listed(const struct tsim *sim, ts_pair_fn *visit, void *context)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_contact_list *list = &sim->neigh->contacts;

	for (size_t r = 0; r < list->n; r++) {
		size_t i = (size_t)list->i[r], j = (size_t)list->j[r];
		double d[3];

		ts_sub(p->x[i], p->x[j], d);
		if (!overlap(p, i, j, d))
			continue;
		visit(context, i, j < p->n ? j : (size_t)p->ghost_owner[j - p->n], d);
		if (j >= p->n)
			continue;
		ts_scale(-1, d, d);
		visit(context, j, i, d);
	}
}

struct search {
	const struct tsim *sim;
	const struct ts_particles *p;
	ts_excluded_fn *excluded; /* NULL: no pair is */
	ts_pair_fn *visit;
	void *context;
};

static void visit_found(void *context, size_t i, size_t j, const double d[3])
{
	const struct search *s = context;

	if (overlap(s->p, i, j, d) && !(s->excluded && s->excluded(s->sim, i, j, d)))
		s->visit(s->context, i, j, d);
}

enum ts_status ts_overlaps_visit(const struct tsim *sim, ts_pair_fn *visit, void *context)
{
	const struct ts_particles *p = sim->particles;
	struct search s = { sim, p, ts_neigh_excluded(sim), visit, context };
	double most = 0;

	if (list_has_all(sim)) {
		visit_listed(sim, visit, context);
		return TS_OK;
	}
	for (size_t i = 0; i < p->n; i++)
		most = p->radius[i] > most ? p->radius[i] : most;
	if (!(most > 0))
		return TS_OK;
	/* pairs that just touch are in reach */
	return ts_pairs_visit(&sim->domain->box, sim->dimension, (const double(*)[3])p->x, p->n,
			      2 * most * (1 + 1e-9), visit_found, &s);
}
