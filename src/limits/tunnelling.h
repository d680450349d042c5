/* Particles that move farther than their radius in a step: whether they may meet anything on their path. If
 * not, as in a dilute flow, nothing is wrong; otherwise contacts could be missed or begin too deep. */
#ifndef TS_LIMITS_TUNNELLING_H
#define TS_LIMITS_TUNNELLING_H

#include "core/sim.h"

/* Of the particles of all ranks that have just moved by more than their radius, that of the least identity that has, or may have,
 * something on its path v dt: another particle with a different velocity, a wall, a mesh, a fixed face through which it has
 * left the box. *hit: its index on the rank that has it; else SIZE_MAX. `what`, of `room` bytes, describes it for a message:
 * " past ...". All positions and velocities are finite. All ranks call it. Fails without memory. */
enum ts_status ts_tunnelling_find(struct tsim *sim, size_t *hit, char *what, size_t room);

#endif
