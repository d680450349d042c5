/* While particles are divided among ranks: the observed contacts of one wall with the particles of all ranks, which each rank
 * has. They are sorted as those of one rank, so that sums over them (wall/surface_contacts.h) have the same bits. */
#ifndef TS_WALL_SHARED_CONTACTS_H
#define TS_WALL_SHARED_CONTACTS_H

#include "wall/surface_contacts.h"

/* Until the next forces: replaces the lists of touching and conducting contacts of this rank by those of all ranks, which all call it. */
enum ts_status ts_shared_contacts_make(struct tsim *sim, struct ts_wall *w);
/* The same, before an iteration of all of them in a step, for the walls made of this surface: observers then have the same sums
 * on all ranks. Without ranks does nothing. */
enum ts_status ts_shared_contacts_find(struct tsim *sim, const struct ts_instance *surface);
/* Element k of w->shared. */
struct ts_shared_contact {
	int32_t surface, rank;
	bool conducts; /* only */
	struct ts_surface_contact contact;
};
static inline const struct ts_surface_contact *ts_shared_contact(const struct ts_wall *w, size_t k)
{
	return &((const struct ts_shared_contact *)(const void *)w->shared.data)[k].contact;
}
/* In the plan of the wall: what ranks will send. */
void ts_shared_contacts_plan(const struct tsim *sim, const struct ts_wall *w, struct ts_plan_report *report);

#endif
