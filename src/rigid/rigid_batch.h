/* Motion of many rigid bodies: their rotation in vectors of bodies, their members one by one. The numbers are bitwise
 * those of ts_body_kick, ts_body_move and ts_rigid_place. */
#ifndef TS_RIGID_RIGID_BATCH_H
#define TS_RIGID_RIGID_BATCH_H

#include "rigid/rigid.h"

/* Half kick and drift of the bodies order[from] .. order[to - 1], whose members are listed; their members follow. */
void ts_rigid_begin_bodies(struct tsim *sim, size_t from, size_t to);
/* Sums forces and torques of members, half kick, velocities of members. */
void ts_rigid_end_bodies(struct tsim *sim, size_t from, size_t to);
/* Both: the end of a step and the beginning of the next one. */
void ts_rigid_end_and_begin_bodies(struct tsim *sim, size_t from, size_t to);
/* Sums forces and torques of members, T += arm x F, and sets those of constrained directions to 0. */
void ts_rigid_sum_forces(struct tsim *sim, size_t from, size_t to);

#endif
