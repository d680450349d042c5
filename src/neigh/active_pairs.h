/* Active pairs: the candidate pairs whose distance is computed in each step.
 *
 * The contact list holds all pairs that may touch before the next rebuild. Within a few steps only those can
 * touch whose surfaces are nearer than an inner skin. These active pairs are listed in blocks of one contact
 * law each; all other pairs are skipped until two particles may have approached each other by the inner skin.
 * So no contact is missed, and the inner skin affects only the cost. */
#ifndef TS_NEIGH_ACTIVE_PAIRS_H
#define TS_NEIGH_ACTIVE_PAIRS_H

#include "neigh/contact_list.h"

/* Packs the data of all particles (struct ts_contact_sphere) and updates the upper bound of their approach
 * since the active pairs were chosen (list->approach). For local particles this may be done earlier, as a
 * deferred loop (core/deferred_loops.h), once their positions of this step are final. */
void ts_contact_list_locate_locals(struct tsim *sim, struct ts_contact_list *list);
void ts_contact_list_locate(const struct tsim *sim, struct ts_contact_list *list);

/* Whether a pair that is not active may touch: the active pairs must be chosen again. */
bool ts_active_pairs_outdated(const struct ts_contact_list *list);

/* Chooses the active pairs of each of the list->shares shares and sorts them into blocks of one contact law.
 * Slots are not assigned yet; ts_contact_slot gives the index of the active pair of a candidate pair. */
enum ts_status ts_active_pairs_choose(struct tsim *sim, struct ts_contact_list *list);

#endif
