/* Limit of the time step of the network that contacts, walls and bonds form of particles and rigid bodies. */
#ifndef TS_LIMITS_NETWORK_H
#define TS_LIMITS_NETWORK_H

#include "core/sim.h"

/* Reports the largest stable step of the present network, and the particle with the largest part in the
 * fastest mode: for the motion in normal direction and along bonds, which is a limit of stability; and, as
 * advice, including tangential and rolling springs, whose forces are bounded by friction. */
enum ts_status ts_network_report(struct ts_plan_report *report, struct tsim *sim);

#endif
