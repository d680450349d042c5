/* Angular velocity of a group as a whole. */
#ifndef TS_GROUP_GROUP_SPIN_H
#define TS_GROUP_GROUP_SPIN_H

#include "core/sim.h"

/* Centre of mass, and the angular velocity omega of a rigid body of the same point masses with the same
 * angular momentum, L = I omega. If the particles lie on a line, omega along it is 0; for one particle or
 * none omega is 0. */
void ts_group_spin(const struct tsim *sim, int group, double centre[3], double omega[3]);

#endif
