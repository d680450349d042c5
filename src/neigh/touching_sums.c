#include "neigh/touching_sums.h"

#include "base/banned.h"

/* Places the ends of long lists one after the other; returns their length. A particle of c candidate pairs sums c
 * forces at most. */
static size_t place_rests(const struct ts_contact_list *list)
{
	const size_t *first = list->gather.first;
	size_t end = 0;

	for (size_t i = 0; i < list->particles; i++) {
		size_t pairs = first[i + 1] - first[i];

		list->sums[i] = TS_SUMS_STALE;
		list->rest_first[i] = (uint32_t)end;
		end += pairs > TS_SUM_ROW ? pairs - TS_SUM_ROW : 0;
	}
	return end;
}

/* Touching pairs, counted by both particles. */
static size_t count_sums(const struct ts_contact_list *list)
{
	size_t n = 0;

	for (int k = 0; k < list->shares; k++)
		for (size_t b = list->span[k].block; b < list->span[k].block_end; b++)
			n += 2 * list->block[b].touching;
	return n;
}

enum ts_status ts_touching_sums_reset(struct ts_contact_list *list)
{
	/* never NULL: pointers into it are computed even if it is empty */
	TS_TRY(TS_RENEW_UNSET(list->sum, list->sum_capacity, TS_SUM_ROW * list->particles + 1));
	TS_TRY(TS_RENEW_UNSET(list->sums, list->sums_capacity, list->particles));
	TS_TRY(TS_RENEW_UNSET(list->rest_first, list->rest_first_capacity, list->particles));
	list->sum_whole_rows = 2 * count_sums(list) > TS_SUM_ROW * list->particles;
	return TS_RENEW_UNSET(list->sum_rest, list->sum_rest_capacity, place_rests(list) + 1);
}

/* With few branches, since which pairs touch cannot be predicted. */
static void list_slots(const struct ts_contact_list *list, size_t i)
{
	const struct ts_gather *g = &list->gather;
	const uint32_t zero = 2 * list->zero_slot;
	uint32_t *sum = list->sum + TS_SUM_ROW * i, *rest = list->sum_rest + list->rest_first[i], n = 0;
	size_t k = g->first[i], end = g->first[i + 1];

	for (int c = 0; c < TS_SUM_ROW; c++)
		sum[c] = zero;
	for (; k < end && n < TS_SUM_ROW; k++) {
		uint32_t entry = g->entry[k], slot = list->slot[entry >> 1], touches = slot & 1;

		sum[n] = touches ? (slot - 1) | (entry & 1) : zero;
		n += touches;
	}
	for (; k < end; k++) {
		uint32_t entry = g->entry[k], slot = list->slot[entry >> 1], touches = slot & 1;

		rest[n - TS_SUM_ROW] = (slot & ~(uint32_t)1) | (entry & 1);
		n += touches;
	}
	list->sums[i] = n;
}

void ts_touching_sums_update(const struct ts_contact_list *list, size_t from, size_t to)
{
	for (size_t i = from; i < to; i++)
		if (list->sums[i] == TS_SUMS_STALE)
			list_slots(list, i);
}
