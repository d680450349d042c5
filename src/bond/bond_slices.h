/* Bonds sorted by particle for the vectorised loop (bond_loop.h).
 *
 * Each bond is computed twice, once for either partner, so each particle sums its own forces and no
 * force needs to be stored. Particles are arranged in slices of TS_BOND_LANES with similar numbers of
 * bonds, computed side by side (sliced ELLPACK: M. Kreutzer et al., SIAM J. Sci. Comput. 36 (2014)
 * C401). Row k of a slice holds the k-th bond of each of its particles, in the order of the identities
 * of the partners. */
#ifndef TS_BOND_BOND_SLICES_H
#define TS_BOND_BOND_SLICES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"

struct tsim;
struct ts_bonds;

enum { TS_BOND_LANES = 8 };

struct ts_bond_slice {
	size_t first;	/* first row */
	uint32_t depth; /* number of rows: the largest number of bonds of a particle of the slice */
	uint32_t n;	/* number of particles; unused lanes repeat the last one, without bonds */
	int32_t type;	/* bond type, or 0 if the slice has several */
	int32_t particle[TS_BOND_LANES];
};

struct ts_bond_slices {
	struct ts_bond_slice *slice; /* particles without bonds are in no slice */
	size_t n;
	/* per row and lane; where a particle has no k-th bond: partner = itself, rest = 0, bond =
	 * TS_BOND_NONE */
	int32_t (*partner)[TS_BOND_LANES];
	double (*rest)[TS_BOND_LANES];
	uint32_t (*bond)[TS_BOND_LANES]; /* entry of ts_bonds.gather: 2 bond + side */
	size_t rows;
	size_t capacity, partner_capacity, rest_capacity, bond_capacity;
};
#define TS_BOND_NONE UINT32_MAX

/* Builds the slices from the list of bonds; its gather must be up to date. */
enum ts_status ts_bond_slices_build(const struct tsim *sim, struct ts_bonds *bonds);
void ts_bond_slices_release(struct ts_bond_slices *slices);

#endif
