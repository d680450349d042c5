/* Particles that leave through fixed faces and are ignored (thermo_modify lost ignore) are deleted at
 * rebuilds, and so wait, as in LIGGGHTS, until some particle has moved half the skin given. Where the skin
 * in use is larger, this is watched apart: whether anyone has left is looked at then, and rows are rebuilt
 * only if so. */
#ifndef TS_NEIGH_LEAVING_H
#define TS_NEIGH_LEAVING_H

#include "core/sim.h"

/* For the init of a run: whether leaving can be watched apart from rebuilds; the skin may be larger then. */
enum ts_status ts_leaving_init(struct tsim *sim);
bool ts_leaving_apart(const struct tsim *sim);

/* With a rebuild the watch begins anew. */
void ts_leaving_hold(struct tsim *sim);
/* Adds a pass (core/deferred_loops.h) that counts particles which have moved half the skin given. */
void ts_leaving_watch(struct tsim *sim, long *moved);
/* The skin, for one that is wanted larger than given, in which whole numbers of looks have room. */
double ts_leaving_skin(double given, double wanted);
/* When some have: whether to rebuild, as one has left or there will not be time enough for another such
 * look. */
bool ts_leaving_due(struct tsim *sim);

#endif
