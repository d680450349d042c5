/* How one rigid body moves. */
#ifndef TS_RIGID_RIGID_MOTION_H
#define TS_RIGID_RIGID_MOTION_H

#include "rigid/rigid.h"

/* Puts the members, in these rows, where the body is, with its motion. */
void ts_rigid_place(struct tsim *sim, const struct ts_body *body, const int32_t *row, size_t n);

/* A step of velocity Verlet of one body: half a kick, a move, half a kick with the new forces. After the move
 * its velocities are those of the middle of the step, as with single spheres. */
void ts_body_kick(struct ts_body *body, double h);
void ts_body_move(struct ts_body *body, double dt);

#endif
