/* Courant number, residual and divergence of a substep of the fluid. */
#ifndef TS_FLOW_STEP_DIAGNOSTICS_H
#define TS_FLOW_STEP_DIAGNOSTICS_H

#include "core/sim.h"

/* Computes Courant number, residual and divergence of the last substep; an error if it was unstable.
 * `before`: the velocity at its beginning. */
enum ts_status ts_projection_check_substep(struct ts_instance *self, struct tsim *sim,
					   double *const before[3], double dt);

#endif
