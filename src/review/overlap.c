/* Check of the review: particles that overlap each other. */
#include "review/overlap.h"

#include <math.h>

#include "bond/bonds.h"
#include "contact/contact_loop.h"
#include "contact/contact_view.h"
#include "contact/pair.h"
#include "law/elastic_energy.h"
#include "review/internal.h"

#include "base/banned.h"

void ts_review_add(struct ts_review_overlaps *o, const struct ts_granular_model *model,
		   const struct ts_granular_pair *law, const struct ts_touch *t)
{
	const double nothing[TS_GRANULAR_MEMORY + 1] = { 0 };
	double least = t->wall ? t->radius[0] : fmin(t->radius[0], t->radius[1]);
	double depth = t->overlap / least, energy;
	struct ts_granular_model dry = *model; /* without liquid bridges: only the elastic energy counts */

	dry.cohesion = ts_cohesion_bridges(model) ? TS_COHESION_OFF : model->cohesion;
	energy = ts_granular_has_energy(&dry) ? ts_granular_energy(&dry, law, t, nothing) : 0;

	o->n++;
	energy = isfinite(energy) ? energy : 0; /* -check continues with a law that was refused */
	o->energy += energy;
	o->newest = depth > o->depth;
	if (!o->newest)
		return;
	o->depth = depth;
	o->overlap = t->overlap;
	o->speed = energy > 0 ? sqrt(2 * energy / t->m_eff) : 0;
}

/* Both particles were in a previous run: their overlap is a result of forces. */
static bool both_settled(const struct ts_particles *p, size_t i, size_t j)
{
	return p->tag[i] <= p->max_run_tag && p->tag[j] <= p->max_run_tag;
}

static void check_candidate(const struct tsim *sim, const struct ts_pair *pair, size_t r,
			    struct ts_review_overlaps *o)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;
	size_t i = (size_t)list->i[r], j = (size_t)list->j[r];
	const struct ts_granular_model *model = ts_pair_model(pair, p->type[i], p->type[j]);
	struct ts_granular_model at_rest =
		*model; /* -check: the column omega may be missing if a line failed */
	struct ts_touch t;

	if (both_settled(p, i, j) || !ts_contact_counts(sim, r, 0) ||
	    ts_bonds_has(sim->bonds, p->tag[i], p->tag[j]))
		return;
	at_rest.tangential = TS_TANGENTIAL_OFF;
	at_rest.rolling = TS_ROLLING_OFF;
	at_rest.twisting = TS_TWISTING_OFF;
	at_rest.cohesion = ts_cohesion_bridges(model) ? TS_COHESION_OFF : model->cohesion;
	ts_contact_touch(p, i, j, &at_rest, &t);
	if (!(t.overlap > ts_review_depth * fmin(t.radius[0], t.radius[1])))
		return;
	ts_review_add(o, model, ts_pair_law(pair, p->type[i], p->type[j]), &t);
	if (o->newest)
		o->a = i, o->b = p->tag[j];
}

static enum ts_status report_overlaps(struct tsim *sim, const struct ts_review_overlaps *o)
{
	const struct ts_particles *p = sim->particles;
	const double *x = p->x[o->a];

	return ts_review_report(sim, "overlap", NULL,
				"contacts with an overlap of more than %g %% of a radius at the start: %zu; "
				"the largest overlap is %g (%.3g %%), of particles %d and %d at (%g %g %g); "
				"the total elastic energy is %g, the separation speed of this pair %g; "
				"increase the distances, check the diameters, or use `fix nve/limit` until "
				"the overlaps are gone",
				100 * ts_review_depth, o->n, o->overlap, 100 * o->depth, p->tag[o->a], o->b,
				x[0], x[1], x[2], o->energy, o->speed);
}

enum ts_status ts_review_overlap(struct tsim *sim)
{
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	struct ts_review_overlaps o = { 0 };

	for (size_t r = 0; pair && !ts_review_blind(sim) && r < sim->neigh->contacts.n; r++)
		check_candidate(sim, pair->state, r, &o);
	return o.n ? report_overlaps(sim, &o) : TS_OK;
}
