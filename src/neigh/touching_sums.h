/* Which forces each particle sums: those of its pairs that touch, in the order of its gather list. All other
 * forces are zero. The slots of a particle are listed when it sums them and one of its contacts has begun or ended
 * since they were listed last; all other steps read the list.
 *
 * The first slots of each particle are in a row of fixed length, filled up with a slot that is zero: so sums have
 * no loops of different lengths, which processors cannot predict. Few particles have more. */
#ifndef TS_NEIGH_TOUCHING_SUMS_H
#define TS_NEIGH_TOUCHING_SUMS_H

#include "base/inline.h"
#include "neigh/contact_list.h"

/* In list->sums: the slots of the particle must be listed again. */
#define TS_SUMS_STALE UINT32_MAX

/* Number of slots in a row of list->sum; 32 bytes, aligned. */
enum { TS_SUM_ROW = 8 };

/* Allocates the lists of all particles; none is up to date. The blocks of active pairs have been made. */
enum ts_status ts_touching_sums_reset(struct ts_contact_list *list);
/* Lists the slots of the particles from .. to-1 where they are not up to date, once all their pairs are computed. */
void ts_touching_sums_update(const struct ts_contact_list *list, size_t from, size_t to);

/* The k-th entry of the particle, k < list->sums[i]. */
TS_INLINE uint32_t ts_touching_sums_entry(const struct ts_contact_list *list, size_t i, size_t k)
{
	return k < TS_SUM_ROW ? list->sum[TS_SUM_ROW * i + k]
			      : list->sum_rest[list->rest_first[i] + k - TS_SUM_ROW];
}

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
