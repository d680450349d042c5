/* Clusters: sets of particles connected by a distance criterion, by bonds, or by both. */
#ifndef TS_BOND_CLUSTERS_H
#define TS_BOND_CLUSTERS_H

#include "core/sim.h"

/* For each local particle the smallest identity of its cluster; 0 outside the group. Particles of the
 * group are connected if their centres are nearer than `cutoff` (0: no distance criterion) and, if
 * `bonds`, if they are bonded. Particles without a connection have their own identity if `alone` or if they
 * are bonded to particles outside the group only, else 0. */
enum ts_status ts_clusters_find(const struct tsim *sim, int group, double cutoff, bool bonds, bool alone,
				struct ts_table *out);

#endif
