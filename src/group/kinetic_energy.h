/* Kinetic energies of groups. A clump of several spheres (fix multisphere) counts as one particle: its
 * spheres share the energy of its centre of mass, and its rotation is left to compute
 * erotate/multisphere, as in LIGGGHTS. Members of other rigid bodies count one by one. */
#ifndef TS_GROUP_KINETIC_ENERGY_H
#define TS_GROUP_KINETIC_ENERGY_H

#include "core/sim.h"

/* m v^2 / 2 and I omega^2 / 2 of particle i. */
double ts_kinetic_energy(const struct tsim *sim, size_t i);
double ts_kinetic_energy_rotation(const struct tsim *sim, size_t i);

/* The sums over the group, rounded once, so that the order of the particles does not matter. */
double ts_group_kinetic_energy(const struct tsim *sim, int group);
double ts_group_rotation_energy(const struct tsim *sim, int group);

#endif
