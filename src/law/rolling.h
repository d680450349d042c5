/* Rolling friction: a torque -T_r on i and +T_r on j against the relative rotation w_r.
 *
 *   cdt     T_r = mu_r k_n delta R* w_r/|w_r|
 *   epsd    a spring along the rolling angle, M += k_r w_r h, k_r = 2.25 k_n mu_r^2 R*^2, limited to
 *           mu_r |F_n| R*; below the limit with a dashpot 2 eta_r sqrt(I k_r) w_r
 *   epsd2   k_r = k_t R*^2, no dashpot
 *   epsd3   k_r = a given factor times k_n mu_r^2 R*^2 (J. Ai, J.-F. Chen, J. M. Rotter, J. Y. Ooi,
 *           Powder Technol. 206 (2011) 269; K. Iwashita, M. Oda, J. Eng. Mech. 124 (1998) 285)
 *   sds     law/tangential_turning.h: a pseudo-force F_r against the rolling velocity v_r = R* w_r x n,
 *           with spring, dashpot and slider limited to mu_r |F_n|; T_r = -R* n x F_r (S. Luding, Granul.
 *           Matter 10 (2008) 235; Y. Wang et al., Particuology 23 (2015) 49)
 *
 * The component of w_r along n is ignored unless the model has torsion. */
#ifndef TS_LAW_ROLLING_H
#define TS_LAW_ROLLING_H

#include "law/tangential_turning.h"

/* Constant directional torque: it is proportional to the elastic force k_n delta, and is projected
 * after it has been computed with the whole |w_r|. */
TS_INLINE void ts_rolling_constant(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				   const struct ts_touch *t, const struct ts_normal *n, double torque[3])
{
	double speed = ts_norm(t->roll), limit = c->rolling_friction * n->kn * t->overlap * t->r_eff;

	ts_scale(speed > 0 ? limit / speed : 0, t->roll, torque);
	if (!m->torsion)
		ts_project(t->n, torque);
}

TS_INLINE double ts_rolling_stiffness(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				      const struct ts_touch *t, const struct ts_normal *n)
{
	double r2 = t->r_eff * t->r_eff, mu2 = c->rolling_friction * c->rolling_friction;

	if (m->rolling == TS_ROLLING_EPSD2)
		return n->kt * r2;
	return (m->rolling == TS_ROLLING_EPSD3 ? c->rolling_stiffness : 2.25) * n->kn * mu2 * r2;
}

TS_INLINE bool ts_rolling_remembers_torque(const struct ts_granular_model *m)
{
	return m->rolling > TS_ROLLING_CDT && m->rolling < TS_ROLLING_SDS;
}

/* Moment of inertia of the rolling pair about the contact point. */
TS_INLINE double ts_rolling_inertia(const struct ts_granular_model *m, const struct ts_touch *t)
{
	double factor = m->plane ? 1.5 : 1.4;
	double a = t->mass[0] * t->radius[0] * t->radius[0];
	double b = t->mass[1] * t->radius[1] * t->radius[1];

	return t->wall ? factor * t->mass[0] * t->r_eff * t->r_eff : factor * (a * b / (a + b));
}

/* The spring torque includes the present increment also in the set-up of a run, as in LIGGGHTS, but is
 * stored only in steps. */
TS_INLINE void ts_rolling_spring(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				 const struct ts_touch *t, const struct ts_normal *n, double dt, bool advance,
				 double stored[3], double torque[3])
{
	double k = ts_rolling_stiffness(m, c, t, n), length, factor, dashpot = 0;
	double limit = fabs(n->limit) * t->r_eff * c->rolling_friction;
	double roll[3] = { t->roll[0], t->roll[1], t->roll[2] };

	if (!m->torsion)
		ts_project(t->n, roll);
	for (int d = 0; d < 3; d++)
		torque[d] = stored[d] + k * dt * roll[d];
	length = ts_norm(torque);
	if (m->rolling != TS_ROLLING_EPSD2)
		dashpot = 2 * c->rolling_viscosity * sqrt(ts_rolling_inertia(m, t) * k);
	/* free of branches, so that the loop over contacts is vectorised */
	factor = length > limit ? limit / length : 1;
	dashpot = length > limit ? 0 : dashpot;
	ts_scale(factor, torque, torque);
	for (int d = 0; d < 3 && advance; d++)
		stored[d] = torque[d];
	ts_axpy(dashpot, roll, torque);
}

TS_INLINE void ts_rolling_slider(const struct ts_granular_pair *c, const struct ts_touch *t,
				 const struct ts_normal *n, double step, double stored[3], double torque[3])
{
	struct ts_slider slider = { .k = c->roll_stiffness,
				    .gamma = c->roll_damping,
				    .limit = c->rolling_friction * fabs(n->limit) };
	double velocity[3], force[3], turned[3];

	ts_cross(t->spin, t->n, velocity);
	ts_scale(t->r_eff, velocity, velocity);
	ts_slider_advance(&slider, t->n, velocity, step, stored);
	ts_slider_force(&slider, velocity, stored, force);
	ts_cross(t->n, force, turned);
	ts_scale(-t->r_eff, turned, torque);
}

TS_INLINE void ts_rolling_torque(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				 const struct ts_touch *t, const struct ts_normal *n, double dt, bool advance,
				 double *stored, double torque[3])
{
	if (m->rolling == TS_ROLLING_OFF)
		torque[0] = torque[1] = torque[2] = 0;
	else if (m->rolling == TS_ROLLING_CDT)
		ts_rolling_constant(m, c, t, n, torque);
	else if (m->rolling == TS_ROLLING_SDS)
		ts_rolling_slider(c, t, n, advance ? dt : 0, stored, torque);
	else
		ts_rolling_spring(m, c, t, n, dt, advance, stored, torque);
}

#endif
