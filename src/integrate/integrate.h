/* Steps of integrators for the particles of a group. */
#ifndef TS_INTEGRATE_INTEGRATE_H
#define TS_INTEGRATE_INTEGRATE_H

#include "core/sim.h"

/* One pass over the particles, which may wait (core/deferred_loops.h); what is 0 is not done. In this
 * order: */
struct ts_integration {
	double early; /* x += early v */
	double kick;  /* v += kick f/m */
	double turn;  /* omega += turn T/I, for spheres or discs as ts_inertia_factor says; nobody turns where
			 * nothing makes torques */
	double drift; /* x += drift v */
};
void ts_integrate(struct tsim *sim, int group, const struct ts_integration *step);

#endif
