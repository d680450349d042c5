/* Sorts particles in memory by their position, so that neighbours in space are near each other in memory. */
#ifndef TS_NEIGH_ORDER_H
#define TS_NEIGH_ORDER_H

#include "core/sim.h"

/* Below this number of particles all data fit into the cache, and the particles keep the order in which they
 * were created. */
enum { TS_ORDER_LEAST = 4096 };

/* Sorts the local particles by cells, then by identities, if they are far from that order. The result depends
 * only on the present positions and order, so it is the same in a run cut in two; no result of a run depends
 * on it. */
enum ts_status ts_order_by_place(struct tsim *sim);

#endif
