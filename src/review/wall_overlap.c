/* Check of the review: particles that overlap walls. */
#include "review/internal.h"

#include <math.h>

#include "review/overlap.h"
#include "wall/wall.h"

#include "base/banned.h"

static void make_wall_touch(const struct tsim *sim, size_t i, double distance,
			    const struct ts_granular_model *model, struct ts_touch *t)
{
	const struct ts_particles *p = sim->particles;

	*t = (struct ts_touch){ .wall = true,
				.n = { 1 },
				.distance = distance,
				.radius = { p->radius[i] },
				.mass = { p->mass[i] },
				.overlap = p->radius[i] - distance,
				.r_eff = p->radius[i],
				.m_eff = 1 / p->imass[i] };
	ts_granular_arms(model, t);
}

static enum ts_status report_overlaps(struct tsim *sim, const struct ts_instance *by,
				      const struct ts_review_overlaps *o)
{
	const struct ts_particles *p = sim->particles;
	const double *x = p->x[o->a];

	return ts_review_report(sim, "wall_overlap", &by->where,
				"particles that overlap this wall by more than %g %% of their radius at the "
				"start: %zu; the largest overlap is %g (%.3g %%), of particle %d at (%g %g "
				"%g); the total elastic energy is %g, the separation speed of this particle "
				"%g; move the wall or the particles, check the diameters, or use `fix "
				"nve/limit` until the overlaps are gone",
				100 * ts_review_depth, o->n, o->overlap, 100 * o->depth, p->tag[o->a], x[0],
				x[1], x[2], o->energy, o->speed);
}

static enum ts_status check_wall(struct tsim *sim, const struct ts_instance *by, const struct ts_wall *w)
{
	const struct ts_particles *p = sim->particles;
	struct ts_review_overlaps o = { 0 };

	for (size_t k = 0; k < w->contacts.n;) {
		int type = 1;
		double distance;
		size_t i = ts_wall_deepest_contact(w, sim, k, &k, &distance, &type);
		struct ts_touch t;

		if (!(distance < (1 - ts_review_depth) * p->radius[i]) || p->tag[i] <= p->max_run_tag ||
		    !(p->imass[i] > 0))
			continue;
		make_wall_touch(sim, i, distance, ts_wall_model(w, sim), &t);
		ts_review_add(&o, ts_wall_model(w, sim), ts_wall_law(w, sim, type, p->type[i]), &t);
		if (o.newest)
			o.a = i;
	}
	return o.n ? report_overlaps(sim, by, &o) : TS_OK;
}

enum ts_status ts_review_wall_overlap(struct tsim *sim)
{
	const struct ts_instance *by;
	const struct ts_wall *w;

	for (size_t k = 0; !ts_review_blind(sim) && (w = ts_walls_next(sim, &k, &by));)
		TS_TRY(check_wall(sim, by, w));
	return TS_OK;
}
