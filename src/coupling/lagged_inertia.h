/* Particles that are light, or densely packed, in a fluid that learns their acceleration a step later. */
#ifndef TS_COUPLING_LAGGED_INERTIA_H
#define TS_COUPLING_LAGGED_INERTIA_H

#include "core/sim.h"
#include "flow/fluid.h"

/* Reports cells in which pressure gradient and added mass of the step before make the velocities of particles and fluid
 * oscillate with growing amplitude, for any time step. `self`: the fix whose group they are; `pressed`: the pressure gradient
 * acts on them. */
enum ts_status ts_lagged_inertia_report(struct ts_instance *self, struct tsim *sim, bool pressed,
					struct ts_plan_report *report);

#endif
