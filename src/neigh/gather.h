/* Gather lists: for each local particle, the rows of a pair list (contacts, bonds) it has a part
 * in.
 *
 * Forces are computed over pairs, without write conflicts; then each particle adds up its own in
 * the order of its partners' keys (identities). So sums depend neither on threads nor on the order
 * of pairs or particles in memory. */
#ifndef TS_NEIGH_GATHER_H
#define TS_NEIGH_GATHER_H

#include <stddef.h>
#include <stdint.h>

#include "base/alloc.h"

struct tsim;

struct ts_gather {
	/* for particle i the entries first[i] .. first[i+1]-1; an entry is 2 row + side, side 1
	 * where i is the second of the pair */
	size_t *first;
	uint32_t *entry;
	size_t first_capacity, entry_capacity;
};

/* Of a pair list: the particle row at a side of a pair, and the key of its partner. */
typedef size_t ts_gather_end(const void *list, size_t row, int side);
typedef uint64_t ts_gather_key(const void *list, size_t row, int side);

/* f[i] += the forces of its pairs, reversed where i is the second. */
void ts_gather_forces(struct tsim *sim, const struct ts_gather *gather, const double (*force)[3]);
void ts_gather_release(struct ts_gather *gather);

/* Sorts a short list by keys. */
static inline __attribute__((always_inline)) void
ts_gather_sort(uint32_t *entry, size_t n, ts_gather_key *key, const void *list)
{
	for (size_t k = 1; k < n; k++) {
		uint32_t e = entry[k];
		uint64_t mine = key(list, e >> 1, (int)(e & 1));
		size_t at = k;

		for (; at; at--) {
			uint32_t before = entry[at - 1];

			if (key(list, before >> 1, (int)(before & 1)) <= mine)
				break;
			entry[at] = before;
		}
		entry[at] = e;
	}
}

/* Makes the lists of n particles over a number of pairs; ends that are no local particle (>= n) are
 * left out. Inlined, so that `end` and `key` are. */
static inline __attribute__((always_inline)) enum ts_status
ts_gather_index(struct ts_gather *g, size_t n, size_t rows, ts_gather_end *end, ts_gather_key *key,
		const void *list)
{
	TS_TRY(TS_GROW(g->first, g->first_capacity, n + 2));
	TS_TRY(TS_GROW(g->entry, g->entry_capacity, 2 * rows));
	for (size_t i = 0; i < n + 2; i++)
		g->first[i] = 0;
	for (size_t r = 0; r < rows; r++)
		for (int side = 0; side < 2; side++)
			if (end(list, r, side) < n)
				g->first[end(list, r, side) + 2]++;
	for (size_t i = 2; i < n + 2; i++)
		g->first[i] += g->first[i - 1];
	for (size_t r = 0; r < rows; r++)
		for (int side = 0; side < 2; side++)
			if (end(list, r, side) < n)
				g->entry[g->first[end(list, r, side) + 1]++] =
					(uint32_t)(2 * r) + (uint32_t)side;
	for (size_t i = 0; i < n; i++)
		ts_gather_sort(g->entry + g->first[i], g->first[i + 1] - g->first[i], key, list);
	return TS_OK;
}

#endif
