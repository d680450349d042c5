/* Keeps neighbours in space near each other in memory. */
#ifndef TS_NEIGH_ORDER_H
#define TS_NEIGH_ORDER_H

#include "core/sim.h"

/* Below so many particles all they need fits into the caches, and they keep the order in which they
 * were created. */
enum { TS_ORDER_LEAST = 4096 };

/* Puts the local particles in the order of cells, then of identities, if they are far from it. The order
 * depends on the present positions and order only, so a run cut in two has the same; no result depends on
 * it. */
enum ts_status ts_order_by_place(struct tsim *sim);

#endif
