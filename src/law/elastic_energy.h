/* Elastic energy of a contact: the energy it would return if it opened without losses. Dashpots and
 * sliders store none.
 *
 *   spring, hooke, hooke/stiffness, hooke/modulus  1/2 k_n delta^2
 *   hertz, hertz/stiffness          2/5 k_n delta^2, since k_n ~ sqrt(delta)
 *   sjkr                            -k V, V the integral of the contact area over delta: with the
 *                                   distance r, s = Ri + Rj, D = Ri - Rj: V = pi/4 delta^2 ((2 s + r)/3
 *                                   - D^2/r); at a wall pi delta^2 (2 R + r)/3
 *   sjkr2                           -k pi delta^2 2R*; at a wall -k pi delta^2 R
 *   dmt                             that of hertz, minus 4 pi w R delta
 *   jkr                             8 E a^5/(15 R^2) - 8/3 sqrt(pi w E) a^(7/2)/R + 2 pi w a^2: the
 *                                   integral of the force over delta from a = 0
 *   tangential, rolling spring      1/2 k_t xi^2, 1/2 M^2/k_r: at the present overlap
 *   twisting, rolling by sds        1/2 k phi^2, 1/2 k xi^2
 *
 * hooke/hysteresis and edinburgh are plastic: the energy it returns depends on the unloading path. Liquid bridges have
 * no potential energy either, since their liquid changes. */
#ifndef TS_LAW_ELASTIC_ENERGY_H
#define TS_LAW_ELASTIC_ENERGY_H

#include "law/granular_force.h"
#include "math/constants.h"

static inline bool ts_granular_has_energy(const struct ts_granular_model *m)
{
	return m->normal != TS_NORMAL_HOOKE_HYSTERESIS && m->normal != TS_NORMAL_EDINBURGH &&
	       !ts_cohesion_bridges(m);
}

static inline double ts_cohesion_energy(const struct ts_granular_model *m, const struct ts_granular_pair *c,
					const struct ts_touch *t)
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

static inline double ts_normal_energy(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				      const struct ts_touch *t, const struct ts_normal *n)
{
	bool hertz = m->normal == TS_NORMAL_HERTZ || m->normal == TS_NORMAL_HERTZ_STIFFNESS ||
		     m->normal > TS_NORMAL_AREA_HOOKE;
	double w = c->surface_energy, r = t->r_eff, e = ts_jkr_modulus(c), a = n->area, a2 = a * a;

	if (m->normal == TS_NORMAL_AREA_JKR)
		return a2 * (8 * e * a2 * a / (15 * r * r) - 8.0 / 3 * sqrt(TS_PI * w * e * a) * a / r +
			     2 * TS_PI * w);
	return (hertz ? 0.4 : 0.5) * n->kn * t->overlap * t->overlap -
	       (m->normal == TS_NORMAL_AREA_DMT ? ts_pull_off_force(m, c, r) * t->overlap : 0);
}

/* Energy of the tangential spring. */
static inline double ts_tangential_energy(const struct ts_granular_model *m, const struct ts_granular_pair *c,
					  const struct ts_normal *n, const double *memory)
{
	if (ts_tangential_slider_of(m, c, n).force)
		return n->kt > 0 ? ts_spring_energy(1 / n->kt, memory) : 0;
	return ts_tangential_remembers(m) ? ts_spring_energy(n->kt, memory) : 0;
}

/* Energy of the springs of rolling and twisting friction. */
static inline double ts_turning_energy(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				       const struct ts_touch *t, const struct ts_normal *n,
				       const double *memory)
{
	double energy = 0, k = ts_rolling_remembers_torque(m) ? ts_rolling_stiffness(m, c, t, n) : 0;

	if (m->rolling == TS_ROLLING_SDS)
		energy += ts_spring_energy(c->roll_stiffness, memory + ts_granular_rolling_at(m));
	if (m->twisting != TS_TWISTING_OFF) {
		double phi = memory[ts_granular_twist_at(m)];

		energy += 0.5 * ts_twist_of(m, c, n).k * phi * phi;
	}
	if (k > 0)
		energy += ts_spring_energy(1 / k, memory + ts_granular_rolling_at(m));
	return energy;
}

/* Elastic energy of a contact; `memory`: its history, as in ts_granular_contact. */
static inline double ts_granular_energy(const struct ts_granular_model *m, const struct ts_granular_pair *c,
					const struct ts_touch *t, const double *memory)
{
	struct ts_normal n;
	double memory_of_normal[TS_NORMAL_MEMORY] = { 0 };

	ts_normal_force(m, c, t, memory_of_normal, &n);
	return ts_normal_energy(m, c, t, &n) + ts_cohesion_energy(m, c, t) +
	       ts_tangential_energy(m, c, &n, memory) + ts_turning_energy(m, c, t, &n, memory);
}

#endif
