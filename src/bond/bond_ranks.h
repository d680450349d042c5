/* Bonds divided among ranks: each rank has those of its own particles. A bond between particles of two ranks is on both,
 * which compute it from the same bits; it is counted, and recorded when it breaks, by the rank of its first particle. */
#ifndef TS_BOND_BOND_RANKS_H
#define TS_BOND_BOND_RANKS_H

#include "core/carried.h"
#include "core/sim.h"

struct ts_bonds;
struct ts_identities;

struct ts_bond_ranks {
	bool divided; /* the list has the bonds of this rank only */
	/* bonds of all ranks, and what ts_bonds had, when all ranks had the same numbers the last time */
	int64_t all, created, broken;
	size_t events;
};

/* Number of bonds, of all ranks. */
size_t ts_bonds_count(const struct ts_bonds *bonds);

/* While the particles are divided: the list, which is whole only if there are no bonds yet, is that of this rank from now on.
 * All ranks call it before one of them adds a bond. */
void ts_bonds_divide(struct tsim *sim);
/* Row of the particle, own or copy; -1: neither. */
int32_t ts_bonds_row_of(const struct tsim *sim, const struct ts_identities *own,
			const struct ts_copy_map *copies, int32_t tag);
/* Of a divided list, or one that is divided now: keeps the bonds of particles of this rank whose partners are still there,
 * and finds the rows of both partners. */
enum ts_status ts_bonds_connect_own(struct tsim *sim, struct ts_bonds *bonds);

/* Whether particles were bonded when the contact list was built that is now made again for other particles: has a bond that is
 * not fresh, or one that was not and broke by its force in this step. */
bool ts_bonds_were_listed(const struct tsim *sim, int32_t tag_a, int32_t tag_b);

/* Slot `join`: numbers and events become those of all ranks. */
enum ts_status ts_bonds_join(struct ts_instance *self, struct tsim *sim);
/* Slot `claim`. */
enum ts_status ts_bonds_claim(struct ts_instance *self, struct tsim *sim, const struct ts_copy_map *copies,
			      struct ts_claims *claims);
extern const struct ts_carrier ts_bonds_carrier;

#endif
