/* Balance of a rigid body with three coordinates q - a height and two slopes - in a field of stiff forces F(q, v):
 *
 *   F(q, v) = M (rate v + acceleration),   v = rate q + velocity,
 *
 * which is equilibrium if rate = 0 and velocity = 0, and one step of an implicit method otherwise. */
#ifndef TS_POLISH_BALANCE_H
#define TS_POLISH_BALANCE_H

#include "base/status.h"

struct ts_balance {
	void *context;
	/* Forces at q with the rates v. An error ends the search. */
	enum ts_status (*forces)(void *context, const double q[3], const double v[3], double out[3]);
	/* Derivatives of the forces [force][coordinate] at the last q and v. */
	enum ts_status (*slopes)(void *context, double by_q[3][3], double by_v[3][3]);
	/* The largest part, at most 1, of a change of the last q that may be tried at once. */
	double (*reach)(void *context, const double change[3]);

	/* A change of q[0] that is large at the last q, > 0. */
	double (*length)(void *context);

	double mass[3];
	double rate, velocity[3], acceleration[3];
	double scale[3]; /* forces against which the rest is judged, > 0 */
};

/* Backward differences of second order (C. F. Curtiss & J. O. Hirschfelder, Proc. Natl. Acad. Sci. 38 (1952) 235), stable for any
 * step: sets rate, velocity and acceleration from the last two states, `last` steps apart, for a step dt. last = 0: there is
 * one, then of first order, and also if the step has become much longer. */
void ts_balance_step(struct ts_balance *b, double dt, double last, const double q[2][3],
		     const double v[2][3]);

/* Newton's method from q, which becomes the solution, with the forces evaluated there. Far from it, where it would not
 * converge, steps are damped by the forces on v: the body then moves as without mass, by fewer and longer steps the nearer it
 * is (pseudo-transient continuation: C. T. Kelley & D. E. Keyes, SIAM J. Numer. Anal. 35 (1998) 508). Returns the status of a failed evaluation, or
 * TS_PHYSICS if there is no solution; *rest is then what is left of the forces, relative to their scale. */
enum ts_status ts_balance_solve(const struct ts_balance *b, double q[3], double *rest);

#endif
