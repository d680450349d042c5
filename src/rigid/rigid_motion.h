/* One rigid body: what spheres make of it, and how it moves. */
#ifndef TS_RIGID_RIGID_MOTION_H
#define TS_RIGID_RIGID_MOTION_H

#include "rigid/rigid.h"

/* Mass, centre, moments, orientation, velocities of the particles as they are, each a sphere; and of a
 * tensor of inertia xx, yy, zz, xy, xz, yz about the centre of mass the moments and the orientation. */
enum ts_status ts_rigid_of_spheres(struct tsim *sim, const int32_t *row, size_t n, struct ts_body *body);
void ts_rigid_principal(struct ts_body *body, const double tensor[6]);

/* Puts the members, in these rows, where the body is, with its motion. */
void ts_rigid_place(struct tsim *sim, const struct ts_body *body, const int32_t *row, size_t n);

/* A step of velocity Verlet of one body: half a kick, a move, half a kick with the new forces. After the move
 * its velocities are those of the middle of the step, as with single spheres. */
void ts_body_kick(struct ts_body *body, double h);
void ts_body_move(struct ts_body *body, double dt);

#endif
