/* Steps of time integrators for the particles of a group. */
#ifndef TS_INTEGRATE_INTEGRATE_H
#define TS_INTEGRATE_INTEGRATE_H

#include "core/sim.h"

/* One pass over the particles, which is deferred (core/deferred_loops.h). Each member is a time; one that is
 * 0 is left out. In this order: */
struct ts_integration {
	double drift_first; /* x += drift_first v */
	double kick;	    /* v += kick f/m */
	/* omega += kick_omega T/I, I of spheres or discs (ts_inertia_factor); left out if nothing computes
	 * torques */
	double kick_omega;
	double drift; /* x += drift v */
};
void ts_integrate(struct tsim *sim, int group, const struct ts_integration *step);

#endif
