/* Particles that move farther than their radius in a step: whether they may meet anything on their path. If
 * not, as in a dilute flow, nothing is wrong; otherwise contacts could be missed or begin too deep. Evaluated
 * only for the few particles that are so fast. */
#ifndef TS_LIMITS_TUNNELLING_H
#define TS_LIMITS_TUNNELLING_H

#include "core/sim.h"

/* Whether there is, or may be, something on the path v dt that particle i has just moved: another particle
 * with a different velocity, a wall, a mesh, a fixed face through which it has left the box. `what`, of
 * `room` bytes, describes it for a message: " past ...". */
bool ts_tunnelling_hits(struct tsim *sim, size_t i, char *what, size_t room);

#endif
