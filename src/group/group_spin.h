/* How a group turns as a whole. */
#ifndef TS_GROUP_GROUP_SPIN_H
#define TS_GROUP_GROUP_SPIN_H

#include "core/sim.h"

/* The centre of mass and the angular velocity with which a rigid body of the same masses at the same
 * places would have the same angular momentum: L = I omega. Where the particles stand in a line, the turn
 * about it is 0; of one particle, or none, all is 0. */
void ts_group_spin(const struct tsim *sim, int group, double centre[3], double omega[3]);

#endif
