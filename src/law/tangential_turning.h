/* Spring, dashpot and slider; the spring rotates with the contact plane and keeps its length (S.
 * Luding, Granul. Matter 10 (2008) 235, eqs. 17 and 20):
 *
 *   xi <- (xi - (xi.n) n) |xi|/|xi - (xi.n) n|,  then xi += v h;   F = -k xi - gamma v
 *
 * If |F| > limit, F is scaled to the limit, and xi to the part that the dashpot leaves of it.
 *
 *   linear           k_t as given
 *   mindlin          k_t a, a the radius of the contact area (R. D. Mindlin, J. Appl. Mech. 16 (1949)
 *                    259)
 *   mindlin_rescale  the same, but xi is scaled with a when a decreases (C. Thornton, S. J. Cummins, P.
 *                    W. Cleary, Powder Technol. 233 (2013) 30)
 *   .../force        the spring force is stored instead of the elongation: P -= k_t a v h, F = P - gamma
 *                    v */
#ifndef TS_LAW_TANGENTIAL_TURNING_H
#define TS_LAW_TANGENTIAL_TURNING_H

#include "law/normal.h"

struct ts_slider {
	double k, gamma, limit;
	bool force; /* the history is the spring force, not the elongation */
};

/* Spring force over the stored xi: -k, or 1 if the force is stored. */
TS_INLINE double ts_slider_factor(const struct ts_slider *s)
{
	return s->force ? 1 : -s->k;
}

TS_INLINE void ts_slider_advance(const struct ts_slider *s, const double n[3], const double velocity[3],
				 double step, double xi[3])
{
	double before = ts_norm(xi), after;

	if (!(step > 0))
		return;
	ts_project(n, xi);
	after = ts_norm(xi);
	if (after > 0)
		ts_scale(before / after, xi, xi);
	ts_axpy(s->force ? -s->k * step : step, velocity, xi);
}

/* Beyond the limit without any elongation, i.e. by the dashpot alone, the force is 0. */
TS_INLINE void ts_slider_force(const struct ts_slider *s, const double velocity[3], double xi[3],
			       double force[3])
{
	double factor = ts_slider_factor(s), size;

	for (int d = 0; d < 3; d++)
		force[d] = factor * xi[d] - s->gamma * velocity[d];
	size = ts_norm(force);
	if (!(size > s->limit))
		return;
	if (!(ts_norm(xi) > 0)) {
		force[0] = force[1] = force[2] = 0;
		return;
	}
	ts_scale(s->limit / size, force, force);
	for (int d = 0; d < 3 && (s->force || s->k > 0); d++)
		xi[d] = (force[d] + s->gamma * velocity[d]) / factor;
}

TS_INLINE bool ts_tangential_rescales(const struct ts_granular_model *m)
{
	return m->tangential == TS_TANGENTIAL_MINDLIN_RESCALE ||
	       m->tangential == TS_TANGENTIAL_MINDLIN_RESCALE_FORCE;
}

TS_INLINE struct ts_slider ts_tangential_slider_of(const struct ts_granular_model *m,
						   const struct ts_granular_pair *c,
						   const struct ts_normal *n)
{
	return (struct ts_slider){ .k = n->kt,
				   .gamma = n->gammat,
				   .limit = c->friction * fabs(n->limit),
				   .force = m->tangential == TS_TANGENTIAL_INCREMENTAL ||
					    m->tangential == TS_TANGENTIAL_MINDLIN_FORCE ||
					    m->tangential == TS_TANGENTIAL_MINDLIN_RESCALE_FORCE };
}

/* *last: radius of the contact area in the last step. */
TS_INLINE void ts_tangential_turning(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				     const struct ts_touch *t, const struct ts_normal *n, double step,
				     double xi[3], double *last, double force[3])
{
	struct ts_slider slider = ts_tangential_slider_of(m, c, n);

	if (ts_tangential_rescales(m) && step > 0) {
		if (n->area < *last)
			ts_scale(n->area / *last, xi, xi);
		*last = n->area;
	}
	ts_slider_advance(&slider, t->n, t->slip, step, xi);
	ts_slider_force(&slider, t->slip, xi, force);
}

#endif
