/* While particles are divided among ranks: the observed contacts of one wall with the particles of all ranks, which each rank
 * has. They are sorted as those of one rank, so that sums over them (wall/surface_contacts.h) have the same bits. */
#ifndef TS_WALL_SHARED_CONTACTS_H
#define TS_WALL_SHARED_CONTACTS_H

#include "wall/surface_contacts.h"

/* Until the next forces: replaces the lists of touching and conducting contacts of this rank by those of all ranks, which all call it. */
enum ts_status ts_shared_contacts_make(struct tsim *sim, struct ts_wall *w);
const struct ts_surface_contact *ts_shared_contact(const struct ts_wall *w, size_t k);
/* In the plan of the wall: what ranks will send. */
void ts_shared_contacts_plan(const struct tsim *sim, const struct ts_wall *w, struct ts_plan_report *report);

#endif
