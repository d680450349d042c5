/* Which forces each particle sums: those of its pairs that touch, in the order of its gather list. All other
 * forces are zero. The slots of a particle are listed when it sums them and one of its contacts has begun or ended
 * since they were listed last; all other steps read the list. */
#ifndef TS_NEIGH_TOUCHING_SUMS_H
#define TS_NEIGH_TOUCHING_SUMS_H

#include "base/inline.h"
#include "neigh/contact_list.h"

/* In list->sums: the slots of the particle must be listed again. */
#define TS_SUMS_STALE UINT32_MAX

/* Allocates the lists of all particles; none is up to date. */
enum ts_status ts_touching_sums_reset(struct ts_contact_list *list);
/* Lists the slots of the particles from .. to-1 where they are not up to date, once all their pairs are computed. */
void ts_touching_sums_update(const struct ts_contact_list *list, size_t from, size_t to);

/* To be called when an active pair begins or ceases to touch; other threads may do so for the same particles. */
TS_INLINE void ts_touching_sums_expire(const struct ts_contact_list *list, const struct ts_active_pair *pair)
{
#pragma omp atomic write
	list->sums[pair->i] = TS_SUMS_STALE;
	if ((size_t)pair->j >= list->particles) /* a ghost sums nothing */
		return;
#pragma omp atomic write
	list->sums[pair->j] = TS_SUMS_STALE;
}

#endif
