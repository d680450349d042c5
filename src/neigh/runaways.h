/* Particles that move by more than their radius in a step, or to where nothing is: they end the run, unless they meet nothing
 * on their path, as in a dilute flow. */
#ifndef TS_NEIGH_RUNAWAYS_H
#define TS_NEIGH_RUNAWAYS_H

#include "core/sim.h"
#include "particle/particles.h"

/* dt2: the time step squared */
bool ts_runaways_has(const struct ts_particles *p, size_t i, double dt2);
/* Between CHECK and the exchange of particles: an error if one of them may have met something. All ranks call it. While the
 * particles are divided, the rank that has the particle returns the error, which ends all. */
enum ts_status ts_runaways_stop(struct tsim *sim);

#endif
