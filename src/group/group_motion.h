/* Centre of mass of a group, and its motion as a whole. Sums are exact and rounded once, positions are unwrapped. Particles
 * are points of mass, clumps are bodies: rigid/rigid_share.h. */
#ifndef TS_GROUP_GROUP_MOTION_H
#define TS_GROUP_GROUP_MOTION_H

#include "core/sim.h"

/* Centre of mass and its velocity; 0 for an empty group. */
void ts_group_centre(const struct tsim *sim, int group, double x[3]);
void ts_group_velocity(const struct tsim *sim, int group, double v[3]);

/* Centre of mass, and the angular velocity omega of a rigid body of the same point masses and clumps with the same
 * angular momentum, L = I omega. If the particles lie on a line, omega along it is 0; for one particle or
 * none omega is 0. */
void ts_group_spin(const struct tsim *sim, int group, double centre[3], double omega[3]);

#endif
