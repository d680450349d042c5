/* The motion of one contact along its normal while nothing else changes:
 *
 *   m q'' = -F(q, q') + m g,   F = k q + c q'  (linear),   k ~ q^(1/2), c ~ q^(1/4) or q^(1/2)  (Hertz)
 *
 * q the overlap, m the effective mass, g what all other forces accelerate it by. Integrated by the
 * classical Runge-Kutta scheme of fourth order in eighths of a step: only steps in which a contact begins
 * or ends need it. */
#ifndef TS_LAW_IMPACT_H
#define TS_LAW_IMPACT_H

#include "law/normal.h"

struct ts_impact {
	double mass, g;
	double k, c; /* at the overlap `at` */
	double at;
	bool hertz, root; /* k ~ q^(1/2), then c ~ q^(1/2) if root, else q^(1/4) */
	bool no_tension;  /* the contact ends where the force is 0, else where the overlap is */
};

static inline struct ts_impact ts_impact_of(const struct ts_granular_model *m, const struct ts_touch *t,
					    const struct ts_normal *n)
{
	return (struct ts_impact){ .mass = t->m_eff,
				   .k = n->kn,
				   .c = n->gamman,
				   .at = t->overlap,
				   .hertz = m->normal == TS_NORMAL_HERTZ ||
					    m->normal == TS_NORMAL_HERTZ_STIFFNESS,
				   .root = m->normal == TS_NORMAL_HERTZ_STIFFNESS,
				   .no_tension = m->no_tension };
}

static inline double ts_impact_force(const struct ts_impact *o, double q, double v)
{
	double s;

	if (!o->hertz) /* also below 0: the search for the end needs a smooth force */
		return o->k * q + o->c * v;
	if (!(q > 0))
		return 0;
	s = sqrt(q / o->at);
	return o->k * s * q + o->c * (o->root ? s : sqrt(s)) * v;
}

/* One step of time s of the motion. */
static inline void ts_impact_move(const struct ts_impact *o, double s, double *q, double *v)
{
	static const double share[4] = { 0, 0.5, 0.5, 1 }, weight[4] = { 1, 2, 2, 1 };
	double dq = 0, dv = 0, q1 = 0, v1 = 0;

	for (int k = 0; k < 4; k++) {
		double u = *v + share[k] * s * dv;

		dv = o->g - ts_impact_force(o, *q + share[k] * s * dq, u) / o->mass;
		dq = u;
		q1 += weight[k] * dq;
		v1 += weight[k] * dv;
	}
	*q += s / 6 * q1;
	*v += s / 6 * v1;
}

enum { TS_IMPACT_PARTS = 8 };

static inline void ts_impact_flow(const struct ts_impact *o, double time, double *q, double *v)
{
	for (int k = 0; k < TS_IMPACT_PARTS; k++)
		ts_impact_move(o, time / TS_IMPACT_PARTS, q, v);
}

/* > 0 while the contact lasts. */
static inline double ts_impact_holds(const struct ts_impact *o, double q, double v)
{
	return o->no_tension ? ts_impact_force(o, q, v) : q;
}

/* When, within a part of a step at the end of which it has, a contact has ended: regula falsi (Illinois). */
static inline double ts_impact_end(const struct ts_impact *o, double part, double *q, double *v)
{
	double lo = 0, hi = part, time = 0, q0 = *q, v0 = *v, q1 = q0, v1 = v0;
	double f = ts_impact_holds(o, q0, v0), g;

	ts_impact_move(o, part, &q1, &v1);
	g = ts_impact_holds(o, q1, v1);
	for (int k = 0; k < 12 && f > 0; k++) {
		double held;

		time = lo + (hi - lo) * f / (f - g);
		*q = q0;
		*v = v0;
		ts_impact_move(o, time, q, v);
		held = ts_impact_holds(o, *q, *v);
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

/* The motion until the contact ends or `time` is over; returns how long that took, *ended: which of them. */
static inline double ts_impact_leave(const struct ts_impact *o, double time, double *q, double *v,
				     bool *ended)
{
	double part = time / TS_IMPACT_PARTS;

	*ended = false;
	for (int k = 0; k < TS_IMPACT_PARTS; k++) {
		double q1 = *q, v1 = *v;

		ts_impact_move(o, part, &q1, &v1);
		*ended = !(ts_impact_holds(o, q1, v1) > 0);
		if (*ended)
			return k * part + ts_impact_end(o, part, q, v);
		*q = q1;
		*v = v1;
	}
	return time;
}

#endif
