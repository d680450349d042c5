/* Sub-step contact detection: normal forces of contacts that begin and end within a time step h, for
 * leapfrog-like schemes (velocity Verlet, symplectic Euler), in which the force at t changes the
 * velocity from t - h/2 to t + h/2.
 *
 * The force of a dashpot jumps at the begin and the end of a contact, and it is computed with the
 * velocity of the last half step: two errors of first order. Both vanish if the force of a step is
 * chosen such that the overlap q follows the exact motion of the pair,  m q'' = -F_e(q) - c q' + m g:
 *
 * within a contact q(t+h) - 2 q(t) + q(t-h) of the damped oscillator (k = dF_e/dq) has a closed form:
 *
 *   F = phi F_e + psi c u + (1 - phi) m g,    u = (q(t) - q(t-h))/h, the velocity of the last half step,
 *   phi = |1 - exp(-lambda h)|^2/(omega0 h)^2,  psi = (1 - exp(-2 gamma h))/(2 gamma h),
 *   lambda = gamma + i omega,  omega^2 = omega0^2 - gamma^2,  omega0^2 = k/m,  gamma = c/(2 m)
 *
 * (R. E. Mickens, Nonstandard Finite Difference Models, 1994). It is exact for a linear contact and
 * constant g; at rest F = F_e. g is the difference between the velocity and the target velocity of the
 * last force, over h.
 *
 * The begin of a contact is found one step late, after free flight at u for the time q/u within the
 * contact: the motion is integrated from there over that time and a step, and the force is chosen such
 * that this position is reached. The position after the flight was wrong by q - Q(q/u); the next force
 * corrects this in the velocity.
 *
 * The end is predicted if the integrated motion ends the contact within the next step: the force is
 * chosen such that the velocity of separation is reached, and the remaining overlap exerts no force.
 *
 * For linear laws each of these is of second order or better; the dashpot of Hertz' law, ~ q^(1/4),
 * limits the order to 5/4. Without a dashpot nothing needs correction, and the force is not changed.
 * The history of a contact contains the target velocity u, the position error of the flight, and its
 * stage. */
#ifndef TS_LAW_SUBSTEP_H
#define TS_LAW_SUBSTEP_H

#include "law/impact.h"

enum {
	TS_LOCATED_AIM,
	TS_LOCATED_AHEAD,
	TS_LOCATED_STAGE,
	TS_LOCATED_SLIP, /* target slip velocity of the tangential force, three numbers, if there is one */
	TS_LOCATED_MEMORY = TS_LOCATED_SLIP + 3
};
static inline int ts_substep_memory(const struct ts_granular_model *m)
{
	if (!m->located)
		return 0;
	return m->tangential == TS_TANGENTIAL_OFF ? TS_LOCATED_SLIP : TS_LOCATED_MEMORY;
}
enum ts_substep_stage {
	TS_LOCATED_NEW,	   /* before the first step */
	TS_LOCATED_SET_UP, /* the force of the set-up has a target half a step ahead */
	TS_LOCATED_TOUCHES,
	TS_LOCATED_LEFT /* ended; the remaining overlap exerts no force */
};

/* Times for which the contact lasts, of the step that this force belongs to. */
struct ts_substep {
	double before; /* part of the time since the last force: by which tangential history advances */
	/* part of the interval from half a step before to half a step after; more if a contact begins */
	double around;
};

/* Whether the normal law supports sub-step detection. */
static inline bool ts_substep_supports(const struct ts_granular_model *m)
{
	return m->normal > TS_NORMAL_OFF && m->normal < TS_NORMAL_HOOKE_HYSTERESIS && !m->viscous;
}

/* phi and psi. With z = gamma h, y = omega h: |1 - exp(-lambda h)|^2 = 2 exp(-z) (cosh z - cos y), a
 * series in z^2 + y^2 = (omega0 h)^2 that is also valid for overdamped contacts, y^2 < 0. exp(-z) =
 * (even - odd)/(even + odd), the Pade approximation of order (4, 4): accurate to 4e-13 for z < 0.3, to
 * 4e-8 for z < 1. */
static inline void ts_substep_factors(double z, double w2, double *phi, double *psi)
{
	double a = z * z, b = w2 - a, half = 0.5 + a / 84, even = 1 + a * (3.0 / 28 + a / 1680);
	double inverse = 1 / (even + z * half);
	double series = 1 + (a - b) / 12 + (a * a - a * b + b * b) / 360 + (a - b) * (a * a + b * b) / 20160;

	*phi = (even - z * half) * inverse * series;
	*psi = 2 * half * even * inverse * inverse;
}

/* Target velocity of the step in which a contact was found that began the time q/u ago. */
static inline double ts_substep_begin(const struct ts_impact *o, double h, double q, double u, double *memory,
				      struct ts_substep *l)
{
	double at = 0, v = u, from, time;
	bool ended;

	ts_impact_integrate(o, q / u, &at, &v);
	from = at;
	time = ts_impact_integrate_to_end(o, h, &at, &v, &ended);
	l->before = q / u;
	l->around = l->before / h + (ended ? fmin(time / h, 0.5) : 0.5);
	memory[TS_LOCATED_STAGE] = ended ? TS_LOCATED_LEFT : TS_LOCATED_TOUCHES;
	memory[TS_LOCATED_AHEAD] = ended ? 0 : q - from;
	return ended ? v : (at - q) / h;
}

/* Whether the contact may end in the next step, which starts with `force`. */
static inline bool ts_substep_near_end(const struct ts_impact *o, double h, double q, double u, double force)
{
	double next = u + h * (o->g - force / o->mass), there = q + h * next;

	return there <= 0 ||
	       (o->no_tension && ts_impact_force(o, there, next + 0.5 * (next - u)) < 0.25 * force);
}

/* Target velocity if the contact ends in the next step; else *ended is false. `u`: velocity of the last
 * half step, corrected by the position error of the flight. The velocity at t is the one with which the
 * motion a step back was at q - h u. The target is the velocity v of separation at mid-step, without
 * the change g (h/2 - time) after the separation, and without the g h of the other forces. */
static inline double ts_substep_end(const struct ts_impact *o, double h, double q, double u, double force,
				    struct ts_substep *l, bool *ended)
{
	double at, v = u + 0.5 * h * (o->g - force / o->mass), time;

	for (int k = 0; k < 3; k++) {
		double back = q, w = v;

		ts_impact_integrate(o, -h, &back, &w);
		v += (back - (q - h * u)) / h;
	}
	at = q;
	time = ts_impact_integrate_to_end(o, h, &at, &v, ended);
	if (*ended)
		l->around = time / h + 0.5;
	return v - o->g * (time + 0.5 * h);
}

/* Acceleration of the contact by all other forces, from the last step. */
static inline double ts_substep_other_acceleration(const double *memory, double h, double u)
{
	double stage = memory[TS_LOCATED_STAGE], part = stage == TS_LOCATED_SET_UP ? 0.5 : 1;

	if (stage == TS_LOCATED_NEW || stage == TS_LOCATED_LEFT)
		return 0;
	return (u - memory[TS_LOCATED_AIM]) / (part * h);
}

/* Normal force of a step within a contact. */
static inline double ts_substep_within(struct ts_impact *o, const struct ts_touch *t, double h,
				       double *memory, struct ts_substep *l)
{
	double q = t->overlap, v = -t->vn, phi, psi, force, aim = 0;
	double ahead = memory[TS_LOCATED_AHEAD], u = v + ahead / h;
	double k = (o->hertz ? 1.5 : 1) * o->k;
	bool ended = false;

	o->g = ts_substep_other_acceleration(memory, h, v);
	ts_substep_factors(o->c * h / (2 * o->mass), k * h * h / o->mass, &phi, &psi);
	force = phi * o->k * q + psi * o->c * u + (1 - phi) * o->mass * o->g;
	if (ts_substep_near_end(o, h, q, u, force))
		aim = ts_substep_end(o, h, q, u, force, l, &ended);
	memory[TS_LOCATED_STAGE] = ended ? TS_LOCATED_LEFT : TS_LOCATED_TOUCHES;
	memory[TS_LOCATED_AHEAD] = 0;
	return ended ? o->mass * (v - aim) / h : force - o->mass * ahead / (h * h);
}

/* Replaces the normal force of ts_normal_force, which has filled *n. */
static inline struct ts_substep ts_substep_force(const struct ts_granular_model *m, const struct ts_touch *t,
						 double h, bool advance, double *memory, struct ts_normal *n)
{
	struct ts_impact o = ts_impact_of(m, t, n);
	struct ts_substep l = { advance ? h : 0, 1 };
	double q = t->overlap, v = -t->vn, force = n->force;
	bool left = memory[TS_LOCATED_STAGE] == TS_LOCATED_LEFT;

	if (!(n->gamman > 0) || !(h > 0))
		return l;
	left &= m->no_tension ? !(force > 0) : !(v > 0);
	if (left) {
		force = l.around = 0;
	} else if (!advance) {
		memory[TS_LOCATED_AHEAD] = 0;
		memory[TS_LOCATED_STAGE] = TS_LOCATED_SET_UP;
	} else if (memory[TS_LOCATED_STAGE] == TS_LOCATED_NEW && q < h * v) {
		force = o.mass * (v - ts_substep_begin(&o, h, q, v, memory, &l)) / h;
	} else {
		force = ts_substep_within(&o, t, h, memory, &l);
	}
	if (m->no_tension)
		force = fmax(force, 0);
	memory[TS_LOCATED_AIM] = v - (advance ? h : 0.5 * h) * force / o.mass;
	n->force = n->limit = force;
	n->gammat *= l.around;
	return l;
}

/* Effective mass of the slip motion of two spheres (or discs), rotation included. */
static inline double ts_substep_slip_mass(const struct ts_granular_model *m, const struct ts_touch *t)
{
	return t->m_eff / (m->plane ? 3 : 3.5);
}

/* Slip velocity s at t, as far as springs and dashpots determine it: s = u + h/2 (g + F/m), F = -k_t xi
 * - gamma_t s, with the slip u of the last half step and the acceleration g by all other forces, as
 * above. The caller will advance the spring xi by s over the whole of *step: the excess is subtracted
 * here. `stage`: before this step. */
static inline void ts_substep_advance_slip(const struct ts_granular_model *m, const struct ts_normal *n,
					   const struct ts_substep *l, double stage, bool remembers,
					   double step, const double *memory, double *xi, struct ts_touch *t)
{
	double mass = ts_substep_slip_mass(m, t), z = 0.5 * step * n->gammat / mass;
	bool known = stage == TS_LOCATED_SET_UP || stage == TS_LOCATED_TOUCHES;
	double part = !known ? 0 : stage == TS_LOCATED_SET_UP ? 1 : 0.5;

	for (int k = 0; k < 3; k++) {
		double u = t->slip[k], at = remembers ? xi[k] + l->before * u : 0, s = u;

		if (step > 0)
			s += part * (u - memory[TS_LOCATED_SLIP + k]) - 0.5 * step * n->kt * at / mass;
		t->slip[k] = s / (1 + z);
		if (remembers)
			xi[k] = at - step * t->slip[k];
	}
}

/* Stores the target slip velocity of the force on i. `u`: slip velocity of the last half step. */
static inline void ts_substep_store_slip_target(const struct ts_granular_model *m, const struct ts_touch *t,
						const double u[3], double time, const double force[3],
						double *memory)
{
	for (int k = 0; k < 3; k++)
		memory[TS_LOCATED_SLIP + k] = u[k] + time * force[k] / ts_substep_slip_mass(m, t);
}

#endif
