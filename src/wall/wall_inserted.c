#include "wall/wall_inserted.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "core/ranks.h"
#include "wall/wall.h"

#include "base/banned.h"

/* What is said of the particle that overlaps most, of that with the smallest identity among equals. */
enum { DEPTH, TAG, OVERLAP, X, Y, Z, FACTS };

struct found {
	int64_t n;
	double fact[FACTS]; /* DEPTH: overlap in radii; TAG: less 0, so that the largest is of the smallest */
};

static bool is_deeper(const double a[FACTS], const double b[FACTS])
{
	return a[DEPTH] > b[DEPTH] || (!(a[DEPTH] < b[DEPTH]) && a[TAG] > b[TAG]);
}

static void take(struct found *f, const struct ts_particles *p, size_t i, double distance)
{
	const double overlap = p->radius[i] - distance;
	const double fact[FACTS] = { [DEPTH] = overlap / p->radius[i],
				     [TAG] = -p->tag[i],
				     [OVERLAP] = overlap,
				     [X] = p->x[i][0],
				     [Y] = p->x[i][1],
				     [Z] = p->x[i][2] };

	if (!(fact[DEPTH] > ts_review_depth))
		return;
	f->n++;
	if (is_deeper(fact, f->fact))
		memcpy(f->fact, fact, sizeof fact);
}

static void find(const struct ts_wall *w, const struct tsim *sim, struct found *f)
{
	const struct ts_wall_contacts *c = &w->contacts;
	const struct ts_particles *p = sim->particles;

	for (size_t k = 0; k < c->n;) {
		double distance;
		size_t i;
		int type;

		if (p->tag[c->row[k]] <= w->newest) {
			k++;
			continue;
		}
		i = ts_wall_deepest_contact(w, sim, k, &k, &distance, &type);
		if (p->imass[i] > 0)
			take(f, p, i, distance);
	}
}

/* The particle that overlaps most on any rank. */
static void unite(const struct tsim *sim, struct found *f)
{
	double fact[FACTS] = { -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY };
	bool mine;

	if (!sim->division)
		return;
	ts_ranks_sums(sim, &f->n, 1);
	fact[DEPTH] = ts_ranks_most(sim, f->fact[DEPTH]);
	mine = !(f->fact[DEPTH] < fact[DEPTH]);
	fact[TAG] = ts_ranks_most(sim, mine ? f->fact[TAG] : -INFINITY);
	mine = mine && !(f->fact[TAG] < fact[TAG]);
	for (int k = OVERLAP; mine && k < FACTS; k++)
		fact[k] = f->fact[k];
	ts_ranks_most_of(sim, fact, FACTS);
	memcpy(f->fact, fact, sizeof fact);
}

enum ts_status ts_wall_look_at_inserted(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;
	struct found f = { .fact = { [TAG] = -INFINITY } };
	const double *x = f.fact + X;

	if (sim->particles->max_tag <= w->newest || sim->run.clamped) /* fix nve/limit bounds displacements */
		return TS_OK;
	find(w, sim, &f);
	unite(sim, &f);
	w->newest = sim->particles->max_tag;
	if (!f.n)
		return TS_OK;
	return ts_review_report(sim, "wall_overlap", &self->where,
				"particles that were inserted in step %" PRId64
				" overlap this wall by more than %g %% of their radius: %" PRId64
				"; the largest overlap is %g (%.3g %%), of particle %.0f at (%g %g %g); the "
				"contact force accelerates them; insert them at least a radius from the wall "
				"(all_in yes keeps the whole particle in the region)",
				sim->clock.step, 100 * ts_review_depth, f.n, f.fact[OVERLAP],
				100 * f.fact[DEPTH], -f.fact[TAG], x[0], x[1], x[2]);
}
