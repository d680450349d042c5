/* Pairs of particles that touch or overlap, whatever their contact law: for outputs. */
#ifndef TS_NEIGH_OVERLAPS_H
#define TS_NEIGH_OVERLAPS_H

#include "geom/pairs.h"

struct tsim;

/* Visits the pairs whose distance is at most the sum of the radii, as ts_pairs_visit does, but for those that neigh_modify,
 * special_bonds or a common rigid body exclude. During a run the contact list tells which pairs are near. */
enum ts_status ts_overlaps_visit(const struct tsim *sim, ts_pair_fn *visit, void *context);

#endif
