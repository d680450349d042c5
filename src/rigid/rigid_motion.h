/* A single rigid body: inertia of its spheres, and integration of its motion. */
#ifndef TS_RIGID_RIGID_MOTION_H
#define TS_RIGID_RIGID_MOTION_H

#include "rigid/rigid.h"

/* Computes mass, centre of mass, moments, orientation and velocities from n particles, each a sphere or
 * disc. */
enum ts_status ts_rigid_of_spheres(struct tsim *sim, const int32_t *row, size_t n, struct ts_body *body);
/* The same of n points of mass at the centres of the particles: particles neither rotate nor have moments of their own. */
enum ts_status ts_rigid_of_points(struct tsim *sim, const int32_t *row, size_t n, struct ts_body *body);
/* Principal moments and orientation from an inertia tensor xx, yy, zz, xy, xz, yz about the centre of mass. */
void ts_rigid_principal(struct ts_body *body, const double tensor[6]);

/* Makes the particles row[] members of the body with this id, at their positions in the frame of its principal axes. */
void ts_rigid_attach(struct tsim *sim, const struct ts_body *body, int32_t id, const int32_t *row, size_t n);

/* Computes positions and velocities of the members row[] from those of the body. */
void ts_rigid_place(struct tsim *sim, const struct ts_body *body, const int32_t *row, size_t n);

/* Computes their velocities only. */
void ts_rigid_set_velocities(struct tsim *sim, const struct ts_body *body, const int32_t *row, size_t n);

/* Leaves the force and the torque that accelerate the body: those in its free directions. */
void ts_body_hold(struct ts_body *body);

/* A step of velocity Verlet: half kick, drift, and half kick with the new forces. After the drift
 * velocities are those of the half step, as for single spheres. */
void ts_body_kick(struct ts_body *body, double h);
void ts_body_move(struct ts_body *body, double dt);

#endif
