/* Which particles the live fixes step forward. */
#ifndef TS_PARTICLES_INTEGRATORS_H
#define TS_PARTICLES_INTEGRATORS_H

#include "core/sim.h"

/* The groups of the fixes that do all of `what` (enum ts_integrates), as bits of particles->mask.
 */
uint32_t ts_integrated(const struct tsim *sim, unsigned what);

#endif
