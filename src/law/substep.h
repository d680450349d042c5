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
TS_INLINE void ts_substep_factors(double z, double w2, double *phi, double *psi)
{
	double a = z * z, b = w2 - a, half = 0.5 + a / 84, even = 1 + a * (3.0 / 28 + a / 1680);
	double inverse = 1 / (even + z * half);
	double series = 1 + (a - b) / 12 + (a * a - a * b + b * b) / 360 + (a - b) * (a * a + b * b) / 20160;

	*phi = (even - z * half) * inverse * series;
	*psi = 2 * half * even * inverse * inverse;
}

/* The force of a contact that begins the time q/u ago and, integrated to `from`, moves on to `at` at velocity v in the
 * time `time`. */
TS_INLINE double ts_substep_begun(const struct ts_impact *o, double h, double q, double u, double from,
				  double at, double v, double time, bool ended, double *memory,
				  struct ts_substep *l)
{
	l->before = q / u;
	l->around = l->before / h + (ended && time / h < 0.5 ? time / h : 0.5);
	memory[TS_LOCATED_STAGE] = ended ? TS_LOCATED_LEFT : TS_LOCATED_TOUCHES;
	memory[TS_LOCATED_AHEAD] = ended ? 0 : q - from;
	return o->mass * (u - (ended ? v : (at - q) / h)) / h;
}

/* Whether the contact may end in the next step, which starts with `force`. */
TS_INLINE bool ts_substep_near_end(const struct ts_impact *o, double h, double q, double u, double force)
{
	double next = u + h * (o->g - force / o->mass), there = q + h * next;
	double then = ts_impact_force(o, there, next + 0.5 * (next - u));
	double least = o->no_tension ? 0.25 * force : -INFINITY; /* free of branches */

	return (there <= 0) | (then < least);
}

/* The velocity at t of a contact that may end in the next step is the one with which the motion a step back was at
 * q - h u; u: velocity of the last half step, corrected by the position error of the flight. First guess, and the
 * next one, if the motion with the last guess came from `back`. */
TS_INLINE double ts_substep_guess(const struct ts_impact *o, double h, double u, double force)
{
	return u + 0.5 * h * (o->g - force / o->mass);
}

TS_INLINE double ts_substep_better_guess(double h, double q, double u, double back, double v)
{
	return v + (back - (q - h * u)) / h;
}

enum { TS_SUBSTEP_GUESSES = 3 };

/* The force of a contact that ends after `time` at velocity v. The target is this velocity at mid-step, without the
 * change g (h/2 - time) after the separation, and without the g h of the other forces. u: velocity of the last half
 * step. */
TS_INLINE double ts_substep_ended(const struct ts_impact *o, double h, double u, double v, double time,
				  struct ts_substep *l)
{
	l->around = time / h + 0.5;
	return o->mass * (u - (v - o->g * (time + 0.5 * h))) / h;
}

/* Acceleration of the contact by all other forces, from the last step. u: velocity of the last half step. */
TS_INLINE double ts_substep_other_acceleration(double stage, double aim, double h, double u)
{
	double part = stage == TS_LOCATED_SET_UP ? 0.5 : 1;
	bool unknown = (stage == TS_LOCATED_NEW) | (stage == TS_LOCATED_LEFT);
	double g = (u - aim) / (part * h);

	return unknown ? 0 : g;
}

/* The force of a contact that lasts, without the correction by `ahead`; sets o->g. u: velocity of the last half step. */
TS_INLINE double ts_substep_lasting(struct ts_impact *o, double h, double q, double u, const double *memory)
{
	double k = (o->hertz ? 1.5 : 1) * o->k, phi, psi;

	o->g = ts_substep_other_acceleration(memory[TS_LOCATED_STAGE], memory[TS_LOCATED_AIM], h, u);
	ts_substep_factors(o->c * h / (2 * o->mass), k * h * h / o->mass, &phi, &psi);
	return phi * o->k * q + psi * o->c * (u + memory[TS_LOCATED_AHEAD] / h) + (1 - phi) * o->mass * o->g;
}

/* The force that corrects the position error of the flight in the velocity. */
TS_INLINE double ts_substep_correction(const struct ts_impact *o, double h, double ahead)
{
	return o->mass * ahead / (h * h);
}

enum ts_substep_case {
	TS_SUBSTEP_PLAIN, /* nothing to integrate */
	TS_SUBSTEP_BEGINS,
	TS_SUBSTEP_MAY_END
};

/* What happens in a step of a dashpot contact that has been set up (enum ts_substep_case, as wide as the numbers, for
 * vectors); u: velocity of the last half step, `normal`: force of the law itself. Also the force, in cases other than
 * TS_SUBSTEP_PLAIN that of a contact that lasts, without correction; sets o->g, and for plain contacts memory and
 * *around. */
TS_INLINE long long ts_substep_of_contact(struct ts_impact *o, double h, double q, double u, double normal,
					  double *memory, double *around, double *force)
{
	double ahead = memory[TS_LOCATED_AHEAD], stage = memory[TS_LOCATED_STAGE];
	double lasting = ts_substep_lasting(o, h, q, u, memory), lasts_by = o->no_tension ? normal : u;
	/* marks: all bits set if true */
	long long left = -(long long)(stage == TS_LOCATED_LEFT) & ~-(long long)(lasts_by > 0);
	long long begins = -(long long)(stage == TS_LOCATED_NEW) & -(long long)(q < h * u);
	long long ends = -(long long)ts_substep_near_end(o, h, q, u + ahead / h, lasting) & ~left & ~begins;
	long long special = begins | ends, kept = special | left;
	double corrected = lasting - ts_substep_correction(o, h, ahead), plain = left ? 0 : corrected;

	*around = left ? 0 : 1;
	*force = special ? lasting : plain;
	memory[TS_LOCATED_STAGE] = kept ? stage : TS_LOCATED_TOUCHES;
	memory[TS_LOCATED_AHEAD] = kept ? ahead : 0;
	return (begins & TS_SUBSTEP_BEGINS) | (ends & TS_SUBSTEP_MAY_END);
}

/* Force in a step in which the contact begins. */
static inline double ts_substep_begin(struct ts_impact *o, double h, double q, double u, double *memory,
				      struct ts_substep *l)
{
	double at = 0, v = u, from, time;
	bool ended;

	o->g = 0;
	ts_impact_integrate(o, q / u, &at, &v);
	from = at;
	time = ts_impact_integrate_to_end(o, h, &at, &v, &ended);
	return ts_substep_begun(o, h, q, u, from, at, v, time, ended, memory, l);
}

/* Force in a step in which the contact may end; `force`: if it does not. */
static inline double ts_substep_end(const struct ts_impact *o, double h, double q, double u, double force,
				    double *memory, struct ts_substep *l)
{
	double ahead = memory[TS_LOCATED_AHEAD], corrected = u + ahead / h, at = q, time;
	double v = ts_substep_guess(o, h, corrected, force);
	bool ended;

	for (int k = 0; k < TS_SUBSTEP_GUESSES; k++) {
		double back = q, w = v;

		ts_impact_integrate(o, -h, &back, &w);
		v = ts_substep_better_guess(h, q, corrected, back, v);
	}
	time = ts_impact_integrate_to_end(o, h, &at, &v, &ended);
	memory[TS_LOCATED_STAGE] = ended ? TS_LOCATED_LEFT : TS_LOCATED_TOUCHES;
	memory[TS_LOCATED_AHEAD] = 0;
	return ended ? ts_substep_ended(o, h, u, v, time, l) : force - ts_substep_correction(o, h, ahead);
}

/* The force is final, u: velocity of the last half step: stores the target velocity, after the time `time`. */
TS_INLINE void ts_substep_store_target(const struct ts_granular_model *m, double mass, double u, double time,
				       double force, double *memory, struct ts_normal *n)
{
	if (m->no_tension)
		force = force > 0 ? force : 0;
	memory[TS_LOCATED_AIM] = u - time * force / mass;
	n->force = n->limit = force;
}

/* Replaces the normal force of ts_normal_force, which has filled *n. */
static inline struct ts_substep ts_substep_force(const struct ts_granular_model *m, const struct ts_touch *t,
						 double h, bool advance, double *memory, struct ts_normal *n)
{
	struct ts_impact o = ts_impact_of(m, t, n);
	struct ts_substep l = { advance ? h : 0, 1 };
	double q = t->overlap, u = -t->vn, force = n->force;
	long long what;

	if (!(n->gamman > 0) || !(h > 0))
		return l;
	if (advance) {
		what = ts_substep_of_contact(&o, h, q, u, n->force, memory, &l.around, &force);
		if (what == TS_SUBSTEP_BEGINS)
			force = ts_substep_begin(&o, h, q, u, memory, &l);
		else if (what == TS_SUBSTEP_MAY_END)
			force = ts_substep_end(&o, h, q, u, force, memory, &l);
	} else if (memory[TS_LOCATED_STAGE] == TS_LOCATED_LEFT && !((m->no_tension ? force : u) > 0)) {
		force = l.around = 0;
	} else {
		memory[TS_LOCATED_AHEAD] = 0;
		memory[TS_LOCATED_STAGE] = TS_LOCATED_SET_UP;
	}
	ts_substep_store_target(m, o.mass, u, advance ? h : 0.5 * h, force, memory, n);
	n->gammat *= l.around;
	return l;
}

/* Effective mass of the slip motion of two spheres (or discs), rotation included. */
TS_INLINE double ts_substep_slip_mass(const struct ts_granular_model *m, const struct ts_touch *t)
{
	return t->m_eff / (m->plane ? 3 : 3.5);
}

/* Slip velocity s at t, as far as springs and dashpots determine it: s = u + h/2 (g + F/m), F = -k_t xi
 * - gamma_t s, with the slip u of the last half step and the acceleration g by all other forces, as
 * above. The caller will advance the spring xi by s over the whole of *step: the excess is subtracted
 * here. `stage`: before this step. */
TS_INLINE void ts_substep_advance_slip(const struct ts_granular_model *m, const struct ts_normal *n,
				       const struct ts_substep *l, double stage, bool remembers, double step,
				       const double *memory, double *xi, struct ts_touch *t)
{
	double mass = ts_substep_slip_mass(m, t), z = 0.5 * step * n->gammat / mass;
	bool known = (stage == TS_LOCATED_SET_UP) | (stage == TS_LOCATED_TOUCHES);
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
TS_INLINE void ts_substep_store_slip_target(const struct ts_granular_model *m, const struct ts_touch *t,
					    const double u[3], double time, const double force[3],
					    double *memory)
{
	for (int k = 0; k < 3; k++)
		memory[TS_LOCATED_SLIP + k] = u[k] + time * force[k] / ts_substep_slip_mass(m, t);
}

#endif
