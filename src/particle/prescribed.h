/* Particles whose motion is prescribed by a fix and does not depend on forces. */
#ifndef TS_PARTICLE_PRESCRIBED_H
#define TS_PARTICLE_PRESCRIBED_H

#include "particle/particles.h"

/* Family of fixes that prescribe the motion of particles, unless `free` is set. In contacts such particles
 * have infinite mass, like walls. */
#define TS_FAMILY_PRESCRIBED "prescribed"
struct ts_prescribed_motion {
	bool free; /* some component still follows forces; set in init */
};
/* The groups moved by these fixes, as bits of particles->mask. */
uint32_t ts_prescribed(const struct tsim *sim);

/* The largest speed |v| in the group; 0 if it is empty. */
double ts_prescribed_max_speed(const struct tsim *sim, int group);

#endif
