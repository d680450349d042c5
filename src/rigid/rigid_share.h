/* Particles in sums over groups of mass, momentum and their moments: points of mass. Only spheres of clumps are not, which
 * overlap: their centre of mass is not that of the clump. Each has a share of the clump, mass / mass of the clump: it counts
 * with its mass at the centre of mass of the clump, and with that share of the moments about it. All spheres together are
 * the clump. */
#ifndef TS_RIGID_RIGID_SHARE_H
#define TS_RIGID_RIGID_SHARE_H

#include "rigid/rigid.h"

/* The clump of particle i, or NULL: a body that was inserted from a template of clumps. */
const struct ts_body *ts_rigid_clump_of(const struct tsim *sim, size_t i);

/* Where the mass of particle i is (unwrapped), and its velocity. */
void ts_rigid_share_place(const struct tsim *sim, size_t i, double x[3]);
const double *ts_rigid_share_velocity(const struct tsim *sim, size_t i);
/* Shares of the angular momentum of the clump about its centre of mass; of its moments of inertia about it, xx, yy, zz, xy,
 * xz, yz; 0 for other particles. */
void ts_rigid_share_spin(const struct tsim *sim, size_t i, double spin[3]);
void ts_rigid_share_inertia(const struct tsim *sim, size_t i, double tensor[6]);

#endif
