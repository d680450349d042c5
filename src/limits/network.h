/* The network that contacts, walls and bonds make of particles and rigid bodies, and how long a step it
 * bears. */
#ifndef TS_LIMITS_NETWORK_H
#define TS_LIMITS_NETWORK_H

#include "core/sim.h"

/* Reports the largest step of the network as it is now, with the particle that moves most in its fastest
 * mode: by the motion along the normals and the bonds, which is a limit of stability, and, as advice, by
 * slip and rolling as well, whose forces friction bounds. */
enum ts_status ts_network_report(struct ts_plan_report *report, struct tsim *sim);

#endif
