#include "neigh/touching_sums.h"

#include "base/clones.h"

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
	list->sum_whole_rows = 2 * count_sums(list) > TS_SUM_ROW * list->particles;
	if (list->sums_listed)
		return TS_OK;
	/* never NULL: pointers into it are computed even if it is empty */
	TS_TRY(TS_RENEW_UNSET(list->sum, list->sum_capacity, TS_SUM_ROW * list->particles + 1));
	TS_TRY(TS_RENEW_UNSET(list->sums, list->sums_capacity, list->particles));
	TS_TRY(TS_RENEW_UNSET(list->rest_first, list->rest_first_capacity, list->particles));
	TS_TRY(TS_RENEW_UNSET(list->sum_place, list->sum_place_capacity, TS_SUM_ROW * list->particles + 1));
	TS_TRY(TS_RENEW_UNSET(list->sum_rest, list->sum_rest_capacity, place_rests(list) + 1));
	list->sums_listed = true;
	return TS_OK;
}

/* With few branches, since which pairs touch cannot be predicted. */
static void list_slots(const struct ts_contact_list *list, size_t i)
{
	const struct ts_gather *g = &list->gather;
	const uint32_t zero = 2 * list->zero_slot;
	uint32_t *sum = list->sum + TS_SUM_ROW * i, *rest = list->sum_rest + list->rest_first[i], n = 0;
	uint8_t *place = list->sum_place + TS_SUM_ROW * i;
	size_t k = g->first[i], end = g->first[i + 1];

	for (int c = 0; c < TS_SUM_ROW; c++)
		sum[c] = zero;
	for (; k < end && n < TS_SUM_ROW; k++) {
		uint32_t entry = g->entry[k], slot = list->slot[entry >> 1], touches = slot & 1;

		sum[n] = touches ? (slot - 1) | (entry & 1) : zero;
		place[n] = (uint8_t)(k - g->first[i]);
		n += touches;
	}
	for (; k < end; k++) {
		uint32_t entry = g->entry[k], slot = list->slot[entry >> 1], touches = slot & 1;

		rest[n - TS_SUM_ROW] = (slot & ~(uint32_t)1) | (entry & 1);
		n += touches;
	}
	list->sums[i] = n;
}

TS_CLONES static bool any_stale(const uint32_t *sums, size_t n)
{
	uint32_t most = 0;

#pragma omp simd reduction(max : most)
	for (size_t i = 0; i < n; i++)
		most = sums[i] > most ? sums[i] : most;
	return most == TS_SUMS_STALE;
}

void ts_touching_sums_update(const struct ts_contact_list *list, size_t from, size_t to)
{
	if (!any_stale(list->sums + from, to - from))
		return;
	for (size_t i = from; i < to; i++)
		if (list->sums[i] == TS_SUMS_STALE)
			list_slots(list, i);
}

/* Whether the list of the particle is up to date and a row, all of whose places in the gather list are numbers of one byte. */
static bool is_row(const struct ts_contact_list *list, size_t i)
{
	const size_t *first = list->gather.first;

	return list->sums[i] <= TS_SUM_ROW && first[i + 1] - first[i] <= UINT8_MAX;
}

void ts_touching_sums_renew(void *contact_list, size_t from, size_t to)
{
	const struct ts_contact_list *list = contact_list;
	const struct ts_gather *g = &list->gather;

	for (size_t i = from; i < to; i++) {
		uint32_t *sum = list->sum + TS_SUM_ROW * i;
		const uint8_t *place = list->sum_place + TS_SUM_ROW * i;
		uint32_t n = 0;

		if (!is_row(list, i)) {
			list->sums[i] = TS_SUMS_STALE;
			continue;
		}
		for (; n < list->sums[i]; n++) {
			uint32_t entry = g->entry[g->first[i] + place[n]];

			sum[n] = (list->slot[entry >> 1] & ~(uint32_t)1) | (entry & 1);
		}
		for (; n < TS_SUM_ROW; n++)
			sum[n] = 2 * list->zero_slot;
	}
}

/* Inserts slot and place of an entry of the gather list into the row. */
static void insert(const struct ts_contact_list *list, size_t i, uint32_t entry, uint32_t slot)
{
	uint32_t *sum = list->sum + TS_SUM_ROW * i;
	uint8_t *place = list->sum_place + TS_SUM_ROW * i;
	const uint32_t *entries = list->gather.entry + list->gather.first[i];
	size_t k = list->sums[i], at = 0;

	while (entries[at] != entry)
		at++;
	for (; k > 0 && place[k - 1] > at; k--) {
		sum[k] = sum[k - 1];
		place[k] = place[k - 1];
	}
	sum[k] = 2 * slot | (entry & 1);
	place[k] = (uint8_t)at;
	list->sums[i]++;
}

static void take_out(const struct ts_contact_list *list, size_t i, uint32_t entry, uint32_t slot)
{
	uint32_t *sum = list->sum + TS_SUM_ROW * i;
	uint8_t *place = list->sum_place + TS_SUM_ROW * i;
	size_t n = --list->sums[i], k = 0;

	while (sum[k] != (2 * slot | (entry & 1)))
		k++;
	for (; k < n; k++) {
		sum[k] = sum[k + 1];
		place[k] = place[k + 1];
	}
	sum[n] = 2 * list->zero_slot;
}

static void change_of_particle(const struct ts_contact_list *list, size_t i, uint32_t entry, uint32_t slot,
			       bool touches)
{
	if (i >= list->particles) /* a ghost sums nothing */
		return;
	if (list->chunk[i / TS_CONTACT_CHUNK]
		    .divided) { /* other threads may change the list of the particle, too */
#pragma omp atomic write
		list->sums[i] = TS_SUMS_STALE;
	} else if (touches && list->sums[i] < TS_SUM_ROW && is_row(list, i))
		insert(list, i, entry, slot);
	else if (!touches && list->sums[i] <= TS_SUM_ROW) /* places are not read: no test of their range */
		take_out(list, i, entry, slot);
	else
		list->sums[i] = TS_SUMS_STALE;
}

void ts_touching_sums_change(const struct ts_contact_list *list, const struct ts_active_pair *pair,
			     bool touches)
{
	change_of_particle(list, (size_t)pair->i, 2 * pair->row, pair->slot, touches);
	change_of_particle(list, (size_t)pair->j, 2 * pair->row + 1, pair->slot, touches);
}

struct ts_touching ts_touching_of(const struct ts_contact_list *list, size_t i)
{
	const size_t *first = list->gather.first;

	return list->sums_listed && is_row(list, i)
		       ? (struct ts_touching){ TS_SUM_ROW * i, TS_SUM_ROW * i + list->sums[i], first[i],
					       true }
		       : (struct ts_touching){ first[i], first[i + 1], 0, false };
}
