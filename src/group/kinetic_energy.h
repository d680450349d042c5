/* Kinetic energies of groups. As in LIGGGHTS, a clump (fix multisphere) counts as one particle: its
 * spheres have the velocity of its centre of mass, and its rotational energy is in compute
 * erotate/multisphere. Members of other rigid bodies count as single particles. */
#ifndef TS_GROUP_KINETIC_ENERGY_H
#define TS_GROUP_KINETIC_ENERGY_H

#include "core/sim.h"
#include "particle/group_moments.h"

/* Translational energy m v^2 / 2 and rotational energy I omega^2 / 2 of particle i. */
double ts_kinetic_energy(const struct tsim *sim, size_t i);
double ts_kinetic_energy_rotation(const struct tsim *sim, size_t i);

/* The first for ts_group_sum_blocks; no context. */
void ts_kinetic_energy_terms(const struct tsim *sim, size_t from, size_t n, const void *context,
			     double (*term)[TS_TERM_BLOCK]);

/* The sums over the group; exact and rounded once, so they do not depend on the order of particles. */
double ts_group_kinetic_energy(const struct tsim *sim, int group);
double ts_group_rotation_energy(const struct tsim *sim, int group);
/* With that of clumps. */
double ts_group_all_rotation_energy(const struct tsim *sim, int group);

#endif
