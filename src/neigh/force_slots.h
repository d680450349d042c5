/* Slots: where the forces and torques of active pairs are stored.
 *
 * In most steps a force is needed only until both particles have summed it. Then slots are assigned as a
 * compiler assigns registers: chunks of particles are summed as soon as all their pairs are computed, and the
 * slots of pairs that both particles have summed are reused. So few slots are in use at any time, and they
 * stay in the cache. At steps where an output may read forces of contacts all results are kept: each pair that touches
 * has a slot of its own. */
#ifndef TS_NEIGH_FORCE_SLOTS_H
#define TS_NEIGH_FORCE_SLOTS_H

#include "base/inline.h"
#include "neigh/contact_list.h"

/* Number of blocks that are computed before the next chunks of particles are summed. */
enum { TS_BLOCKS_PER_SUM = 8 };

/* Chooses the active pairs again if they are outdated, loads their history and assigns their slots. `kept`:
 * all results are to be kept. */
enum ts_status ts_force_slots_prepare(struct tsim *sim, struct ts_contact_list *list, bool kept);
/* Forgets the results. Where all are kept they take a fifth of the memory, and what follows needs room: they are freed;
 * those that are passed on are few, and their memory serves the next list. */
void ts_force_slots_forget(struct ts_contact_list *list);
/* Makes the results of all pairs readable by outputs, all zero, before any force has been computed. */
enum ts_status ts_force_slots_keep_all(struct tsim *sim, struct ts_contact_list *list);

/* The next chunk from the *c-th on whose active pairs are all among from .. done-1; list->chunks: there is
 * none. *c is advanced to the first chunk that must wait. */
TS_INLINE size_t ts_contact_chunk_done(const struct ts_contact_list *list, size_t from, size_t done,
				       size_t *c)
{
	for (; *c < list->chunks && list->chunk[*c].end <= done; ++*c)
		if (list->chunk[*c].first >= from && list->chunk[*c].end > 0)
			return (*c)++;
	return list->chunks;
}

#endif
