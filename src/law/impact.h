/* Motion of a single contact along its normal under constant external acceleration:
 *
 *   m q'' = -F(q, q') + m g,   F = k q + c q'  (linear),   k ~ q^(1/2), c ~ q^(1/4), q^(1/2) or constant  (Hertz)
 *
 * with the overlap q, the effective mass m, and the acceleration g by all other forces. Integrated by
 * the classical fourth-order Runge-Kutta scheme in eighths of a time step: it is needed only in steps
 * in which a contact begins or ends. */
#ifndef TS_LAW_IMPACT_H
#define TS_LAW_IMPACT_H

#include "law/normal.h"

/* How c of Hertzian contacts depends on the overlap q. */
enum ts_impact_damping {
	TS_IMPACT_FOURTH_ROOT, /* hertz: c ~ sqrt(k) */
	TS_IMPACT_SQUARE_ROOT, /* hertz/stiffness */
	TS_IMPACT_CONSTANT     /* hertz/stiffness with absolute_damping */
};

struct ts_impact {
	double mass, g;
	double k, c; /* stiffness and damping at the overlap `at` */
	double at;
	bool hertz;			/* k ~ q^(1/2), c by `damping`; else both are constant */
	enum ts_impact_damping damping; /* only with hertz */
	bool no_tension;		/* the contact ends at zero force, else at zero overlap */
};

TS_INLINE enum ts_impact_damping ts_impact_damping_of(const struct ts_granular_model *m)
{
	if (m->normal != TS_NORMAL_HERTZ_STIFFNESS)
		return TS_IMPACT_FOURTH_ROOT;
	return m->absolute_damping ? TS_IMPACT_CONSTANT : TS_IMPACT_SQUARE_ROOT;
}

TS_INLINE struct ts_impact ts_impact_of(const struct ts_granular_model *m, const struct ts_touch *t,
					const struct ts_normal *n)
{
	return (struct ts_impact){ .mass = t->m_eff,
				   .k = n->kn,
				   .c = n->gamman,
				   .at = t->overlap,
				   .hertz = m->normal == TS_NORMAL_HERTZ ||
					    m->normal == TS_NORMAL_HERTZ_STIFFNESS,
				   .damping = ts_impact_damping_of(m),
				   .no_tension = m->no_tension };
}

/* Free of branches, as are all functions that contacts in vectors call (contact/substep_stages.c). */
TS_INLINE double ts_impact_force(const struct ts_impact *o, double q, double v)
{
	double s, c, force;

	if (!o->hertz) /* also for q < 0: the search for the end needs a smooth force */
		return o->k * q + o->c * v;
	s = sqrt(q / o->at);
	c = o->damping == TS_IMPACT_CONSTANT ? o->c
					     : o->c * (o->damping == TS_IMPACT_SQUARE_ROOT ? s : sqrt(s));
	force = o->k * s * q + c * v;
	return q > 0 ? force : 0;
}

/* One Runge-Kutta step over the time s. */
TS_INLINE void ts_impact_rk4_step(const struct ts_impact *o, double s, double *q, double *v)
{
	static const double node[4] = { 0, 0.5, 0.5, 1 }, weight[4] = { 1, 2, 2, 1 };
	double dq = 0, dv = 0, q1 = 0, v1 = 0;

	for (int k = 0; k < 4; k++) {
		double u = *v + node[k] * s * dv;

		dv = o->g - ts_impact_force(o, *q + node[k] * s * dq, u) / o->mass;
		dq = u;
		q1 += weight[k] * dq;
		v1 += weight[k] * dv;
	}
	*q += s / 6 * q1;
	*v += s / 6 * v1;
}

enum { TS_IMPACT_PARTS = 8, TS_IMPACT_SEARCHES = 12 };

static inline void ts_impact_integrate(const struct ts_impact *o, double time, double *q, double *v)
{
	for (int k = 0; k < TS_IMPACT_PARTS; k++)
		ts_impact_rk4_step(o, time / TS_IMPACT_PARTS, q, v);
}

/* Criterion of the end: > 0 while the contact lasts. */
TS_INLINE double ts_impact_end_criterion(const struct ts_impact *o, double q, double v)
{
	double force = ts_impact_force(o, q, v);

	return o->no_tension ? force : q;
}

/* Time of the end of a contact within an interval at whose end it has ended: regula falsi (Illinois
 * method). */
static inline double ts_impact_find_end(const struct ts_impact *o, double part, double *q, double *v)
{
	double lo = 0, hi = part, time = 0, q0 = *q, v0 = *v, q1 = q0, v1 = v0;
	double f = ts_impact_end_criterion(o, q0, v0), g;

	ts_impact_rk4_step(o, part, &q1, &v1);
	g = ts_impact_end_criterion(o, q1, v1);
	for (int k = 0; k < TS_IMPACT_SEARCHES && f > 0; k++) {
		double held;

		time = lo + (hi - lo) * f / (f - g);
		*q = q0;
		*v = v0;
		ts_impact_rk4_step(o, time, q, v);
		held = ts_impact_end_criterion(o, *q, *v);
		if (held > 0) {
			lo = time;
			f = held;
			g *= 0.5;
		} else {
			hi = time;
			g = held;
			f *= 0.5;
		}
		if (held == 0)
			break;
	}
	return time;
}

/* Integrates until the contact ends or `time` has passed; returns the elapsed time; *ended: whether the
 * contact ended. */
static inline double ts_impact_integrate_to_end(const struct ts_impact *o, double time, double *q, double *v,
						bool *ended)
{
	double part = time / TS_IMPACT_PARTS;

	*ended = false;
	for (int k = 0; k < TS_IMPACT_PARTS; k++) {
		double q1 = *q, v1 = *v;

		ts_impact_rk4_step(o, part, &q1, &v1);
		*ended = !(ts_impact_end_criterion(o, q1, v1) > 0);
		if (*ended)
			return k * part + ts_impact_find_end(o, part, q, v);
		*q = q1;
		*v = v1;
	}
	return time;
}

#endif
