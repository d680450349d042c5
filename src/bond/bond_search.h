/* Pairs of particles to be bonded during a run. */
#ifndef TS_BOND_BOND_SEARCH_H
#define TS_BOND_BOND_SEARCH_H

#include "bond/bonds.h"

/* A pair to be bonded; the smaller identity first. */
struct ts_bond_candidate {
	int32_t tag[2];
	size_t row[2]; /* local indices */
	double distance;
};

struct ts_bond_candidates {
	struct ts_bond_candidate *pair;
	size_t n, capacity;
};

/* Whether particles i and j, of which i has the smaller identity, at this distance are to be bonded. */
typedef bool ts_bond_wanted_fn(const void *context, const struct tsim *sim, size_t i, size_t j,
			       double distance);

/* Finds all pairs of the group that are nearer than `reach`, not bonded, and wanted: each once, in the order of the
 * identities. While the particles are divided among ranks: those with a particle of this rank; copies must reach as far
 * (neigh->centre_reach). Two particles at the same position are an error. */
enum ts_status ts_bond_search(struct tsim *sim, int group, double reach, ts_bond_wanted_fn *wanted,
			      const void *context, const struct ts_place *where,
			      struct ts_bond_candidates *out);
/* Adds the bond of a pair, with its distance as rest length. On two ranks it is counted by that of its first particle. */
enum ts_status ts_bonds_add_pair(struct tsim *sim, const struct ts_bond_candidate *pair, int type);
/* After bonds have been added in a run: sorts and connects them, and sets their references. */
enum ts_status ts_bonds_added(struct tsim *sim);

#endif
