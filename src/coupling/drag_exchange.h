/* Exchange of momentum between the particles of a drag fix and a fluid that is solved for. */
#ifndef TS_COUPLING_DRAG_EXCHANGE_H
#define TS_COUPLING_DRAG_EXCHANGE_H

#include "coupling/drag_force.h"

/* Number of steps of the simulation over which the fluid takes the mean of forces; 0: the fluid makes no
 * step in this step of the simulation, and receives the explicit force. */
double ts_drag_steps_to_fluid(const struct ts_drag *s);
/* Adds the reaction to the drag on all particles to the fluid. */
enum ts_status ts_drag_add_to_fluid(struct ts_instance *self, struct tsim *sim);
/* After the step of the fluid: adds B (u' - u) to the forces on the particles. Slot after_step of struct
 * ts_flow_part. */
enum ts_status ts_drag_correct(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
			       double length);

#endif
