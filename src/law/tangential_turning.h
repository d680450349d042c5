/* Spring, dashpot and slider whose spring turns with the plane of contact and keeps its length
 * (S. Luding, Granul. Matter 10 (2008) 235, eqs. 17 and 20):
 *
 *   xi <- (xi - (xi.n) n) |xi|/|xi - (xi.n) n|,  then xi += v h;   F = -k xi - gamma v, where |F| > limit shortened
 *   to that, and xi to what the dashpot leaves of it.
 *
 * linear                 k_t as given
 * mindlin                k_t a, a the radius of the contact area (R. D. Mindlin, J. Appl. Mech. 16 (1949) 259)
 * mindlin_rescale        the same, but when a falls xi falls with it: a contact that opens cannot bear what it bore
 *                        (C. Thornton, S. J. Cummins, P. W. Cleary, Powder Technol. 233 (2013) 30)
 * .../force              the force of the spring is remembered, not its length: P -= k_t a v h, F = P - gamma v */
#ifndef TS_LAW_TANGENTIAL_TURNING_H
#define TS_LAW_TANGENTIAL_TURNING_H

#include "law/normal.h"

struct ts_slider {
	double k, gamma, limit;
	bool force; /* what is remembered is the force of the spring */
};

/* What `xi` stands for in a force: times -k, or itself. */
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

/* A spring without length and a dashpot beyond the limit give no force. */
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

/* *last: a in the last step. */
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
