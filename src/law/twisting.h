/* Twisting friction: a torque T n on i, -T n on j, against the relative rotation rate w about the
 * normal. A spring along the angle phi, phi += w h, with dashpot and slider: T = -k phi - gamma w, |T|
 * <= mu |F_n| (J. S. Marshall, J. Comput. Phys. 228 (2009) 1541, eqs. 29 to 33).
 *
 *   sds       k, gamma and mu as given
 *   marshall  from the tangential law: k = k_t a^2/2, gamma = gamma_t a^2/2, mu = 2/3 a mu_t */
#ifndef TS_LAW_TWISTING_H
#define TS_LAW_TWISTING_H

#include "law/normal.h"

struct ts_twist {
	double k, gamma, friction;
};

TS_INLINE struct ts_twist ts_twist_of(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				      const struct ts_normal *n)
{
	double a2 = n->area * n->area;

	if (m->twisting == TS_TWISTING_SDS)
		return (struct ts_twist){ c->twist_stiffness, c->twist_damping, c->twist_friction };
	return (struct ts_twist){ 0.5 * n->kt * a2, 0.5 * n->gammat * a2, 2.0 / 3.0 * n->area * c->friction };
}

/* Torque T. `step`: time by which the history advances, 0 in the set-up of a run. */
TS_INLINE double ts_twisting_torque(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				    const struct ts_touch *t, const struct ts_normal *n, double step,
				    double *phi)
{
	struct ts_twist twist;
	double rate, torque, limit;

	if (m->twisting == TS_TWISTING_OFF)
		return 0;
	twist = ts_twist_of(m, c, n);
	rate = ts_dot(t->spin, t->n);
	*phi += rate * step;
	torque = -twist.k * *phi - twist.gamma * rate;
	limit = twist.friction * fabs(n->limit);
	if (!(fabs(torque) > limit))
		return torque;
	/* beyond the limit the torque is opposite to the rotation, as in LAMMPS, whatever the spring */
	limit = rate > 0 ? limit : rate < 0 ? -limit : 0;
	if (twist.k > 0)
		*phi = (limit - twist.gamma * rate) / twist.k;
	return -limit;
}

#endif
