/* Elastic energy of a contact: what it would give back if it opened without losses. The dashpots and
 * friction have none.
 *
 *   spring, hooke, hooke/stiffness   1/2 k_n delta^2
 *   hertz, hertz/stiffness           2/5 k_n delta^2, since k_n grows with sqrt(delta)
 *   sjkr                             -k V, V the integral of the area of contact over delta: with r the
 *                                    distance, s = Ri + Rj, D = Ri - Rj:
 *                                    pi/4 delta^2 ((2 s + r)/3 - D^2/r); at a wall pi delta^2 (2 R + r)/3
 *   sjkr2                            -k pi delta^2 2R*; at a wall -k pi delta^2 R
 *   spring of slip, of rolling       1/2 k_t xi^2, 1/2 M^2/k_r: at the present overlap
 *
 * hooke/hysteresis yields: what it gives back depends on the way it opens. */
#ifndef TS_LAW_ENERGY_H
#define TS_LAW_ENERGY_H

#include "law/granular_force.h"

static inline bool ts_granular_has_energy(const struct ts_granular_model *m)
{
	return m->normal != TS_NORMAL_HOOKE_HYSTERESIS;
}

static inline double ts_cohesion_energy(const struct ts_granular_model *m,
					const struct ts_granular_pair *c, const struct ts_touch *t)
{
	double r = t->distance, sum = t->radius[0] + t->radius[1], d = t->radius[0] - t->radius[1];
	double area = TS_PI * t->overlap * t->overlap;

	if (m->cohesion == TS_COHESION_SJKR)
		return -c->cohesion * area *
		       (t->wall ? (2 * sum + r) / 3 : 0.25 * ((2 * sum + r) / 3 - d * d / r));
	if (m->cohesion == TS_COHESION_SJKR2)
		return -c->cohesion * area * (t->wall ? t->radius[0] : 2 * t->r_eff);
	return 0;
}

static inline double ts_spring_energy(double stiffness, const double x[3])
{
	return 0.5 * stiffness * ts_dot(x, x);
}

/* `memory`: of the contact, as in ts_granular_contact. */
static inline double ts_granular_energy(const struct ts_granular_model *m,
					const struct ts_granular_pair *c, const struct ts_touch *t,
					const double *memory)
{
	bool hertz = m->normal == TS_NORMAL_HERTZ || m->normal == TS_NORMAL_HERTZ_STIFFNESS;
	struct ts_normal n;
	double energy, deepest = 0, k;

	ts_normal_force(m, c, t, false, &deepest, &n);
	energy = (hertz ? 0.4 : 0.5) * n.kn * t->overlap * t->overlap + ts_cohesion_energy(m, c, t);
	if (ts_tangential_remembers(m))
		energy += ts_spring_energy(n.kt, memory);
	k = m->rolling > TS_ROLLING_CDT ? ts_rolling_stiffness(m, c, t, &n) : 0;
	if (k > 0)
		energy += ts_spring_energy(1 / k, memory + ts_granular_rolling_at(m));
	return energy;
}

#endif
