/* Steps of integrators for the particles of a group. */
#ifndef TS_PARTICLES_INTEGRATE_H
#define TS_PARTICLES_INTEGRATE_H

#include "core/sim.h"

/* v += kick f/m */
void ts_integrate_kick(struct tsim *sim, int group, double kick);
/* v += kick f/m, then x += drift v */
void ts_integrate_kick_drift(struct tsim *sim, int group, double kick, double drift);
/* x += drift v, then v += kick f/m */
void ts_integrate_drift_kick(struct tsim *sim, int group, double drift, double kick);

#endif
