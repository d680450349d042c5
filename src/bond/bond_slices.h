/* Bonds as their particles see them, for the loop over them (bond_loop.h).
 *
 * Each bond is computed twice, once for either partner: a particle adds up its own as they come, and no
 * force is stored and looked for again. Particles stand side by side in slices, so many as are computed at
 * once, those with about as many bonds together (sliced ELLPACK: M. Kreutzer et al., SIAM J. Sci. Comput.
 * 36 (2014) C401). Row k of a slice has the k-th bond of each particle, in the order of the partners'
 * identities. */
#ifndef TS_BOND_BOND_SLICES_H
#define TS_BOND_BOND_SLICES_H

#include <stddef.h>
#include <stdint.h>

#include "base/status.h"

struct tsim;
struct ts_bonds;

enum { TS_BOND_LANES = 8 };

struct ts_bond_slice {
	size_t first;	/* row */
	uint32_t depth; /* rows: the most bonds that one of the particles has */
	uint32_t n;	/* particles; those behind are the last again, without bonds */
	int32_t type;	/* of the bonds; 0: there are several */
	int32_t particle[TS_BOND_LANES];
};

struct ts_bond_slices {
	struct ts_bond_slice *slice; /* particles without bonds are in none */
	size_t n;
	/* of each row; where a particle has no more bonds: it itself, no length, TS_BOND_NONE */
	int32_t (*partner)[TS_BOND_LANES];
	double (*rest)[TS_BOND_LANES];
	uint32_t (*bond)[TS_BOND_LANES]; /* as an entry of the gather */
	size_t capacity, partner_capacity, rest_capacity, bond_capacity;
};
#define TS_BOND_NONE UINT32_MAX

/* Of the list of bonds, whose gather has been made. */
enum ts_status ts_bond_slices(const struct tsim *sim, struct ts_bonds *bonds);
void ts_bond_slices_release(struct ts_bond_slices *slices);

#endif
