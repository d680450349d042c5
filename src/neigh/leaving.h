/* Particles that leave through fixed faces under `thermo_modify lost ignore` are deleted at rebuilds, that
 * is, as in LIGGGHTS, when some particle has moved half the given skin. If the skin in use is larger, this
 * condition is checked separately: when it holds, particles outside the box are searched for, and the list is
 * rebuilt only if there are some. */
#ifndef TS_NEIGH_LEAVING_H
#define TS_NEIGH_LEAVING_H

#include "core/sim.h"

/* For the init of a run: adds the column of positions that the separate check needs. */
enum ts_status ts_leaving_init(struct tsim *sim);
bool ts_leaving_apart(const struct tsim *sim);

/* To be called at a rebuild: displacements are measured from here. */
void ts_leaving_hold(struct tsim *sim);
/* Defers a loop (core/deferred_loops.h) that counts the particles that have moved half the given skin since
 * the last check. */
void ts_leaving_watch(struct tsim *sim, long *moved);
/* The skin to use, length, at least `wanted`: one within which a whole number of checks fits. */
double ts_leaving_skin(double given, double wanted);
/* Called when some have: whether to rebuild, because a particle has left or the skin does not last until
 * another check. */
bool ts_leaving_due(struct tsim *sim);

#endif
