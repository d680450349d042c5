/* The steps of rigid bodies. */
#ifndef TS_PARTICLES_RIGID_MOTION_H
#define TS_PARTICLES_RIGID_MOTION_H

#include "particles/rigid.h"

/* Puts the members, in these rows, where the body is, with its motion. */
void ts_rigid_place(struct tsim *sim, const struct ts_body *body, const int32_t *row, size_t n);

ts_hook_fn ts_rigid_initial, ts_rigid_clear, ts_rigid_final, ts_rigid_setup;

#endif
