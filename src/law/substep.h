/* Normal forces of contacts that begin and end within a step, for leapfrog-like schemes (velocity Verlet,
 * symplectic Euler) with the step h, in which a force at t changes the velocity from t - h/2 to t + h/2.
 *
 * The dashpot's force jumps where a contact begins and ends, and it is taken with the velocity half a step back:
 * two errors of first order. Both go if the force of a step is such that the overlap q follows the motion of the
 * pair,  m q'' = -F_e(q) - c q' + m g:
 *
 * within   q(t+h) - 2 q(t) + q(t-h) of the damped oscillator (k = dF_e/dq) is known in closed form:
 *
 *            F = phi F_e + psi c u + (1 - phi) m g,    u = (q(t) - q(t-h))/h, the velocity at hand,
 *            phi = |1 - exp(-lambda h)|^2/(omega0 h)^2,  psi = (1 - exp(-2 gamma h))/(2 gamma h),
 *            lambda = gamma + i omega,  omega^2 = omega0^2 - gamma^2,  omega0^2 = k/m,  gamma = c/(2 m)
 *
 *          (as in R. E. Mickens, Nonstandard Finite Difference Models, 1994). Exact for a linear contact and a
 *          constant g; at rest F = F_e. g is the velocity that came otherwise than the last force had aimed at, over h.
 * begin    found one step late, after a flight at u for the time q/u in contact: from there the motion over that
 *          time and a step; the force aims at its place. By then the flight was q - Q(q/u) too far: the next force
 *          knows, and takes that back from the velocity.
 * end      foreseen when the motion ends the contact in the next step: the force aims at the velocity with which
 *          they part, and what is left of the overlap has none.
 *
 * Each is of second order or better for linear laws; Hertz' dashpot, ~ q^(1/4), leaves order 5/4. Without
 * a dashpot there is nothing to correct, and the force is left as it is. What a contact remembers: the
 * velocity u aimed at, how much too far the flight was, its stage. */
#ifndef TS_LAW_SUBSTEP_H
#define TS_LAW_SUBSTEP_H

#include "law/impact.h"

enum {
	TS_LOCATED_AIM,
	TS_LOCATED_AHEAD,
	TS_LOCATED_STAGE,
	TS_LOCATED_SLIP, /* what the tangential force aimed at, three numbers, where there is one */
	TS_LOCATED_MEMORY = TS_LOCATED_SLIP + 3
};
static inline int ts_substep_memory(const struct ts_granular_model *m)
{
	if (!m->located)
		return 0;
	return m->tangential == TS_TANGENTIAL_OFF ? TS_LOCATED_SLIP : TS_LOCATED_MEMORY;
}
enum ts_substep_stage {
	TS_LOCATED_NEW,	   /* no step yet */
	TS_LOCATED_SET_UP, /* the force before the first step has aimed half a step ahead */
	TS_LOCATED_TOUCHES,
	TS_LOCATED_LEFT /* ended, but for what is left of the overlap */
};

/* How much of the step whose force this is the contact lasts. */
struct ts_substep {
	double before; /* of the time since the last force: what tangential memory advances by */
	/* of the time from half a step before to half a step later, or more where a contact begins */
	double around;
};

/* Whether the law is one that can be located. */
static inline bool ts_substep_knows(const struct ts_granular_model *m)
{
	return m->normal > TS_NORMAL_OFF && m->normal < TS_NORMAL_HOOKE_HYSTERESIS && !m->viscous;
}

/* phi and psi. With z = gamma h, y = omega h: |1 - exp(-lambda h)|^2 = 2 exp(-z) (cosh z - cos y), a
 * series of z^2 + y^2 = (omega0 h)^2 that needs no case for overdamped contacts, y^2 < 0. exp(-z) = (even
 * - odd)/(even + odd), Pade's approximation of order (4, 4): exact to 4e-13 for z < 0.3, to 4e-8 for z <
 * 1. */
static inline void ts_substep_factors(double z, double w2, double *phi, double *psi)
{
	double a = z * z, b = w2 - a, half = 0.5 + a / 84, even = 1 + a * (3.0 / 28 + a / 1680);
	double inverse = 1 / (even + z * half);
	double series = 1 + (a - b) / 12 + (a * a - a * b + b * b) / 360 + (a - b) * (a * a + b * b) / 20160;

	*phi = (even - z * half) * inverse * series;
	*psi = 2 * half * even * inverse * inverse;
}

/* The velocity aimed at in a step that ends with a contact begun for q/u. */
static inline double ts_substep_begin(const struct ts_impact *o, double h, double q, double u, double *memory,
				      struct ts_substep *l)
{
	double at = 0, v = u, from, time;
	bool ended;

	ts_impact_flow(o, q / u, &at, &v);
	from = at;
	time = ts_impact_leave(o, h, &at, &v, &ended);
	l->before = q / u;
	l->around = l->before / h + (ended ? fmin(time / h, 0.5) : 0.5);
	memory[TS_LOCATED_STAGE] = ended ? TS_LOCATED_LEFT : TS_LOCATED_TOUCHES;
	memory[TS_LOCATED_AHEAD] = ended ? 0 : q - from;
	return ended ? v : (at - q) / h;
}

/* Whether the contact may end in the next step, which `force` would begin. */
static inline bool ts_substep_near_end(const struct ts_impact *o, double h, double q, double u, double force)
{
	double next = u + h * (o->g - force / o->mass), there = q + h * next;

	return there <= 0 ||
	       (o->no_tension && ts_impact_force(o, there, next + 0.5 * (next - u)) < 0.25 * force);
}

/* The velocity aimed at, if the contact ends; else *ended is false. `u`: as if the flight had not been too
 * far. The velocity at t is the one with which the motion a step back was at q - h u. The velocity v when
 * they part is that of the middle of the step, less what g adds from there on, g (h/2 - time), and without
 * the g h that comes besides. */
static inline double ts_substep_leave(const struct ts_impact *o, double h, double q, double u, double force,
				      struct ts_substep *l, bool *ended)
{
	double at, v = u + 0.5 * h * (o->g - force / o->mass), time;

	for (int k = 0; k < 3; k++) {
		double back = q, w = v;

		ts_impact_flow(o, -h, &back, &w);
		v += (back - (q - h * u)) / h;
	}
	at = q;
	time = ts_impact_leave(o, h, &at, &v, ended);
	if (*ended)
		l->around = time / h + 0.5;
	return v - o->g * (time + 0.5 * h);
}

/* What all else accelerates the contact by, as of the last step. */
static inline double ts_substep_rest(const double *memory, double h, double u)
{
	double stage = memory[TS_LOCATED_STAGE], part = stage == TS_LOCATED_SET_UP ? 0.5 : 1;

	if (stage == TS_LOCATED_NEW || stage == TS_LOCATED_LEFT)
		return 0;
	return (u - memory[TS_LOCATED_AIM]) / (part * h);
}

/* The force of a step within a contact; aims at *aim. */
static inline double ts_substep_within(struct ts_impact *o, const struct ts_touch *t, double h,
				       double *memory, struct ts_substep *l)
{
	double q = t->overlap, v = -t->vn, phi, psi, force, aim = 0;
	double ahead = memory[TS_LOCATED_AHEAD], u = v + ahead / h;
	double k = (o->hertz ? 1.5 : 1) * o->k;
	bool ended = false;

	o->g = ts_substep_rest(memory, h, v);
	ts_substep_factors(o->c * h / (2 * o->mass), k * h * h / o->mass, &phi, &psi);
	force = phi * o->k * q + psi * o->c * u + (1 - phi) * o->mass * o->g;
	if (ts_substep_near_end(o, h, q, u, force))
		aim = ts_substep_leave(o, h, q, u, force, l, &ended);
	memory[TS_LOCATED_STAGE] = ended ? TS_LOCATED_LEFT : TS_LOCATED_TOUCHES;
	memory[TS_LOCATED_AHEAD] = 0;
	return ended ? o->mass * (v - aim) / h : force - o->mass * ahead / (h * h);
}

/* The normal force of a step, instead of that of ts_normal_force, which has filled *n. */
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

/* What the tangential force moves: the slip of two spheres (or discs) that turn, too. */
static inline double ts_substep_slip_mass(const struct ts_granular_model *m, const struct ts_touch *t)
{
	return t->m_eff / (m->plane ? 3 : 3.5);
}

/* The slip s at t, as far as springs and dashpots make it: s = u + h/2 (g + F/m), F = -k_t xi - gamma_t s,
 * with the slip u of half a step before and, as above, g what all else changes it by. The spring xi will
 * be advanced by s for the whole of *step: what is too much is taken back first. `stage`: before this
 * step. */
static inline void ts_substep_slip(const struct ts_granular_model *m, const struct ts_normal *n,
				   const struct ts_substep *l, double stage, bool remembers, double step,
				   const double *memory, double *xi, struct ts_touch *t)
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

/* Afterwards: the slip that the force on i aims at. `u`: half a step before. */
static inline void ts_substep_slips(const struct ts_granular_model *m, const struct ts_touch *t,
				    const double u[3], double time, const double force[3], double *memory)
{
	for (int k = 0; k < 3; k++)
		memory[TS_LOCATED_SLIP + k] = u[k] + time * force[k] / ts_substep_slip_mass(m, t);
}

#endif
