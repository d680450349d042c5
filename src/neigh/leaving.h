/* Particles that leave through fixed faces under `thermo_modify lost ignore` are deleted, as in LIGGGHTS, when some
 * particle has moved half the given skin since particles were looked for last. Where the list is rebuilt at other steps, as
 * its skin is another one or displacements are relative to a moving frame, this condition is watched separately: when it
 * holds, particles outside the box are searched for, and are deleted by a rebuild if there are some; and rebuilds that are
 * due for the list only (sim->run.relist) delete none. */
#ifndef TS_NEIGH_LEAVING_H
#define TS_NEIGH_LEAVING_H

#include "core/sim.h"

/* For the init of a run: adds the column of positions that the separate check needs. */
enum ts_status ts_leaving_init(struct tsim *sim);
bool ts_leaving_apart(const struct tsim *sim);

/* To be called at a rebuild that deletes particles: displacements are measured from here. */
void ts_leaving_hold(struct tsim *sim);
/* If the condition is watched, defers a loop (core/deferred_loops.h) that counts the particles that have moved half the
 * given skin since the last search. */
void ts_leaving_watch(struct tsim *sim, long *moved);
/* The skin to use, length, at least `wanted`: a number of given skins, with room for the last steps. */
double ts_leaving_skin(double given, double wanted);
/* Called when some have: whether a particle has left. */
bool ts_leaving_search(struct tsim *sim);

#endif
