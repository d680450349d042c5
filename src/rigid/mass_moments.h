/* Terms of particle i in sums over particles: mass, momentum and their moments, about the point c where one is given.
 * Particles are points of mass, at their unwrapped positions; spheres of clumps add their shares of the clump
 * (rigid/rigid_share.h). */
#ifndef TS_RIGID_MASS_MOMENTS_H
#define TS_RIGID_MASS_MOMENTS_H

#include "particle/group_moments.h"
#include "rigid/rigid_share.h"

/* m x, m v; the fourth term is m. */
void ts_mass_moment(const struct tsim *sim, size_t i, double term[4]);
void ts_mass_momentum(const struct tsim *sim, size_t i, double term[4]);

/* m d x v, with d = x - c. */
void ts_mass_angular_momentum(const struct tsim *sim, size_t i, const double c[3], double term[3]);

/* Tensors in the order of ts_tensor_names: m (d^2 delta_ab - d_a d_b), m d_a d_b. */
void ts_mass_inertia(const struct tsim *sim, size_t i, const double c[3], double term[6]);
void ts_mass_second_moment(const struct tsim *sim, size_t i, const double c[3], double term[6]);

/* The same for blocks of particles in ts_group_sum_blocks; the context is c, where one is needed. */
void ts_mass_moment_terms(const struct tsim *sim, size_t from, size_t n, const void *centre,
			  double (*term)[TS_TERM_BLOCK]);
void ts_mass_momentum_terms(const struct tsim *sim, size_t from, size_t n, const void *centre,
			    double (*term)[TS_TERM_BLOCK]);
void ts_mass_angular_momentum_terms(const struct tsim *sim, size_t from, size_t n, const void *centre,
				    double (*term)[TS_TERM_BLOCK]);
void ts_mass_inertia_terms(const struct tsim *sim, size_t from, size_t n, const void *centre,
			   double (*term)[TS_TERM_BLOCK]);
void ts_mass_second_moment_terms(const struct tsim *sim, size_t from, size_t n, const void *centre,
				 double (*term)[TS_TERM_BLOCK]);

#endif
