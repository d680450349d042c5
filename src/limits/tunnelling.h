/* Particles that move farther than their radius in a step: whether they may meet anything on their path. If
 * not, as in a dilute flow, nothing is wrong; otherwise contacts could be missed or begin too deep. */
#ifndef TS_LIMITS_TUNNELLING_H
#define TS_LIMITS_TUNNELLING_H

#include "core/sim.h"

/* The first of these particles, fast[0] to fast[n - 1], that has, or may have, something on the path v dt that it has just
 * moved: another particle with a different velocity, a wall, a mesh, a fixed face through which it has left the box.
 * *hit: its index; SIZE_MAX: none. `what`, of `room` bytes, describes it for a message: " past ...". All positions and
 * velocities are finite. Fails without memory. */
enum ts_status ts_tunnelling_find(struct tsim *sim, const size_t *fast, size_t n, size_t *hit, char *what,
				  size_t room);

#endif
