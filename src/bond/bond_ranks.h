/* Bonds divided among ranks: each rank has those of its own particles. A bond between particles of two ranks is on both,
 * which compute it from the same bits; it is counted, and recorded when it breaks, by the rank of its first particle. */
#ifndef TS_BOND_BOND_RANKS_H
#define TS_BOND_BOND_RANKS_H

#include "core/carried.h"
#include "core/sim.h"

struct ts_bonds;

struct ts_bond_ranks {
	bool divided; /* the list has the bonds of this rank only */
	uint32_t
		*number; /* [n] if divided: place of each bond in the list of all ranks when it was divided */
	uint32_t *event_number; /* of the bonds of the events from `events` on */
	size_t number_capacity, event_capacity;
	/* bonds of all ranks, and what ts_bonds had, when all ranks had the same numbers the last time */
	int64_t all, broken;
	size_t events;
};

/* Number of bonds, of all ranks. */
size_t ts_bonds_count(const struct ts_bonds *bonds);

/* Of a divided list, or one that is divided now: keeps the bonds of particles of this rank whose partners are still there,
 * and finds the rows of both partners. */
enum ts_status ts_bonds_connect_own(struct tsim *sim, struct ts_bonds *bonds);
/* Notes which bond the last event is of. */
enum ts_status ts_bonds_note_event(struct ts_bonds *bonds, size_t b);

/* Slot `join`: numbers and events become those of all ranks. */
enum ts_status ts_bonds_join(struct ts_instance *self, struct tsim *sim);
/* Slot `claim`. */
enum ts_status ts_bonds_claim(struct ts_instance *self, struct tsim *sim, const struct ts_copy_map *copies,
			      struct ts_claims *claims);
extern const struct ts_carrier ts_bonds_carrier;

#endif
