/* Active pairs: the rows of the contact list whose distance is computed in each step.
 *
 * The contact list holds all pairs that may touch before the next rebuild. Within a few steps only those
 * can touch whose surfaces are nearer than an inner skin. These active pairs are listed in blocks of one
 * contact law each; the other rows are skipped until two particles may have approached each other by the
 * inner skin. So no contact is missed; the inner skin only decides the cost. */
#ifndef TS_NEIGH_ACTIVE_PAIRS_H
#define TS_NEIGH_ACTIVE_PAIRS_H

#include "neigh/contact_list.h"

/* Packs the data of all particles (struct ts_contact_sphere) and updates how far two of them may have
 * approached since the active pairs were chosen. For local particles, after their positions of this step
 * are final, this may be done earlier as a deferred loop (core/deferred_loops.h). */
void ts_contact_list_locate_locals(struct tsim *sim, struct ts_contact_list *list);
void ts_contact_list_locate(const struct tsim *sim, struct ts_contact_list *list);

/* Whether a row that is not active may touch. */
bool ts_active_pairs_outdated(const struct ts_contact_list *list);

/* Lists the active pairs of each of the rows->shares parallel shares; slot k belongs to pair k; rows->active_index
 * is the index by row. */
#define TS_PAIR_INACTIVE UINT32_MAX
enum ts_status ts_active_pairs_choose(struct tsim *sim, struct ts_contact_list *list);

#endif
