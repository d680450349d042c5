/* Sums of the forces and torques of contacts over each particle. */
#ifndef TS_CONTACT_CONTACT_SUMS_H
#define TS_CONTACT_CONTACT_SUMS_H

#include "neigh/contact_list.h"

/* Adds the forces and torques of their touching pairs to p->f and p->torque of the particles from .. to-1, or
 * overwrites these (list->overwrite_sums). */
typedef void ts_contact_sums_fn(const struct ts_contact_list *list, const struct ts_particles *p, size_t from,
				size_t to);
/* The function for the torques that the list has. */
ts_contact_sums_fn *ts_contact_sums_of(const struct ts_contact_list *list);

#endif
