/* Particles moved into a dense packing, by which -explain estimates the cost of a run that begins with
 * scattered particles and ends with a bed of them. */
#ifndef TS_PARTICLE_CROWD_H
#define TS_PARTICLE_CROWD_H

#include "particle/particles.h"

/* Places all mobile particles, at rest, on a simple cubic lattice from the low corner of the box, with the
 * mean diameter as spacing: six contacts each, as in a bed. Does nothing if the box has not enough sites,
 * since the particles are dense already. Slot `crowd` of the system of particles. */
enum ts_status ts_particles_crowd(struct ts_instance *self, struct tsim *sim);

#endif
