/* The orientation of each particle, a unit quaternion (w, x, y, z), which its angular velocity turns. It is a
 * column `orientation` that exists only if a style needs it; before that all orientations are 1, 0, 0, 0. */
#ifndef TS_PARTICLE_ORIENTATION_H
#define TS_PARTICLE_ORIENTATION_H

#include "core/sim.h"

/* Adds the column, and those of angular velocity and torque. */
enum ts_status ts_orientation_need(struct tsim *sim);
/* The column, [n][4]; NULL: there is none. */
double (*ts_orientation(const struct tsim *sim))[4];
/* Orientation of particle i. */
void ts_orientation_of(const struct tsim *sim, size_t i, double q[4]);
/* Turns all particles by omega dt: exact at constant omega, and of second order with velocity Verlet, whose
 * omega is that of the middle of the step. */
void ts_orientation_advance(struct tsim *sim);
/* Turns particle i about a unit vector; angle in radian. Nothing where there is no column. */
void ts_orientation_turn(const struct tsim *sim, size_t i, const double axis[3], double angle);
/* For the archive function of a style that needs the column. */
enum ts_status ts_orientation_archive(struct tsim *sim, struct ts_archive *archive);

#endif
