#include "neigh/touching_sums.h"

#include "base/banned.h"

enum ts_status ts_touching_sums_reset(struct ts_contact_list *list)
{
	/* never NULL: pointers into it are computed even if it is empty */
	TS_TRY(TS_RENEW_UNSET(list->sum, list->sum_capacity, 2 * list->n + 1));
	TS_TRY(TS_RENEW_UNSET(list->sums, list->sums_capacity, list->particles));
	for (size_t i = 0; i < list->particles; i++)
		list->sums[i] = TS_SUMS_STALE;
	return TS_OK;
}

/* Without branches, since which pairs touch cannot be predicted. */
static void list_slots(const struct ts_contact_list *list, size_t i)
{
	const struct ts_gather *g = &list->gather;
	uint32_t *sum = list->sum + g->first[i], n = 0;

	for (size_t k = g->first[i]; k < g->first[i + 1]; k++) {
		uint32_t entry = g->entry[k], r = entry >> 1;

		sum[n] = 2 * list->slot_of[r] | (entry & 1);
		n += list->touching[r];
	}
	list->sums[i] = n;
}

void ts_touching_sums_update(const struct ts_contact_list *list, size_t from, size_t to)
{
	for (size_t i = from; i < to; i++)
		if (list->sums[i] == TS_SUMS_STALE)
			list_slots(list, i);
}
