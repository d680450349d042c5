/* Which forces each particle sums: those of its pairs that touch, in the order of its gather list. All other
 * forces are zero. Lists are made when the particles sum for the first time, and kept up to date where contacts begin and
 * end, which are few; a list that is not up to date is made anew when it is read.
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

/* To be called when active pairs have been chosen. For a new contact list: allocates the lists of all particles; none is up
 * to date. */
enum ts_status ts_touching_sums_reset(struct ts_contact_list *list);
/* Enters the new slots, once they are assigned, into the lists of the particles from .. to-1 that are up to date. */
void ts_touching_sums_renew(void *contact_list, size_t from, size_t to);
/* Lists the slots of the particles from .. to-1 where they are not up to date, once all their pairs are computed. */
void ts_touching_sums_update(const struct ts_contact_list *list, size_t from, size_t to);

/* The k-th entry of the particle, k < list->sums[i]. */
TS_INLINE uint32_t ts_touching_sums_entry(const struct ts_contact_list *list, size_t i, size_t k)
{
	return k < TS_SUM_ROW ? list->sum[TS_SUM_ROW * i + k]
			      : list->sum_rest[list->rest_first[i] + k - TS_SUM_ROW];
}

/* The entries (2 pair + side) of the gather list of particle i whose pairs touch, in its order:
 *
 *	for (struct ts_touching t = ts_touching_of(list, i); ts_touching_next(list, &t, &entry);) */
struct ts_touching {
	size_t at, end,
		first; /* in sum_place, from the first entry of the gather list on; or in the gather list */
	bool listed;
};
struct ts_touching ts_touching_of(const struct ts_contact_list *list, size_t i);

TS_INLINE bool ts_touching_next(const struct ts_contact_list *list, struct ts_touching *t, uint32_t *entry)
{
	while (t->at < t->end) {
		size_t k = t->listed ? t->first + list->sum_place[t->at] : t->at;

		t->at++;
		*entry = list->gather.entry[k];
		if (t->listed || ts_contact_touches(list, *entry >> 1))
			return true;
	}
	return false;
}

/* To be called when an active pair begins or ceases to touch, by the thread that computes it. */
void ts_touching_sums_change(const struct ts_contact_list *list, const struct ts_active_pair *pair,
			     bool touches);

#endif
