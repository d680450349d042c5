/* Clusters: sets of particles that hang together by nearness, by bonds, or by both. */
#ifndef TS_BOND_CLUSTERS_H
#define TS_BOND_CLUSTERS_H

#include "core/sim.h"

/* For each local particle the smallest identity of its cluster; 0 outside the group. Particles of the
 * group nearer than the cutoff (0: none) belong together, and those with a bond if `bonds`. Where
 * `alone` is false, a particle that belongs to no other has 0. */
enum ts_status ts_clusters_find(const struct tsim *sim, int group, double cutoff, bool bonds, bool alone,
				struct ts_table *out);

#endif
