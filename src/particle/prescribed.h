/* Particles that move as a fix says, whatever acts on them, and the largest speed. */
#ifndef TS_PARTICLE_PRESCRIBED_H
#define TS_PARTICLE_PRESCRIBED_H

#include "particle/particles.h"

/* Family of fixes that move particles whatever acts on them, unless they are free: to contacts they are
 * walls. */
#define TS_FAMILY_PRESCRIBED "prescribed"
struct ts_prescribed_motion {
	bool free; /* some component moves as forces say; set in init */
};
/* The groups that these fixes move, as bits of particles->mask. */
uint32_t ts_prescribed(const struct tsim *sim);

/* The largest speed in the group. */
double ts_prescribed_max_speed(const struct tsim *sim, int group);

#endif
