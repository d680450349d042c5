/* Implicit viscosity: (1 - theta dt nu lap) d = dt (rate of u with the full viscous term and the old
 * pressure), factored by axes into tridiagonal systems; u* = u + d.
 *
 * theta 1/2 (Crank-Nicolson) is of second order; theta 1 (backward Euler) is of first order and damps
 * short waves best. Neither limits the step. Kim & Moin, J. Comput. Phys. 59 (1985) 308. With the old
 * pressure in the predictor (incremental projection) the projection solves for its change phi, and p <- p
 * + phi - theta mu div u*: Brown, Cortez & Minion, J. Comput. Phys. 168 (2001) 464. */
#ifndef TS_FLOW_IMPLICIT_VISCOSITY_H
#define TS_FLOW_IMPLICIT_VISCOSITY_H

#include "flow/fluid.h"
#include "flow/operators.h"

enum ts_flow_viscous { TS_VISCOUS_EXPLICIT, TS_VISCOUS_IMPLICIT, TS_VISCOUS_BACKWARD };

struct ts_viscous_step {
	const struct ts_fluid *fluid; /* u at the beginning, with ghosts, and p */
	const struct ts_operators *operators;
	double nu, dt, theta;
	int threads;
	struct ts_slabs *slabs; /* of ranks, in three dimensions; NULL or not active: this one solves all */
	bool rehearsal; /* of active slabs: ranks exchange what they do in a step, and solve nothing (rank/rehearsal.h) */
};
/* out: on entry u + dt (convection and body force), on return u*, at faces where the velocity is not
 * given. */
enum ts_status ts_viscous_step(const struct ts_viscous_step *step, double *const out[3]);

#endif
