/* Particles that move farther than their radius in a step: whether they can meet anything on their way. In
 * a dilute flow they need not, and then nothing is wrong; where something stands in the way, contacts
 * would be missed or begin too deep. Asked for the few that are so fast only. */
#ifndef TS_LIMITS_TUNNELLING_H
#define TS_LIMITS_TUNNELLING_H

#include "core/sim.h"

/* The particle i has just moved by v dt. True: something is, or may be, on its way - another particle that
 * it does not go along with, a wall, a mesh, a fixed face that it has left the box through -, and `what`
 * says it: " past ...". */
bool ts_tunnelling_hits(struct tsim *sim, size_t i, char *what, size_t room);

#endif
