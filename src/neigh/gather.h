/* Gather lists: for each local particle, its pairs in a list of pairs (contacts, bonds).
 *
 * Forces are computed over pairs, without write conflicts; then each particle sums its own in the order of
 * the identities of its partners. So sums depend neither on the number of threads nor on the order of pairs
 * or particles in memory. */
#ifndef TS_NEIGH_GATHER_H
#define TS_NEIGH_GATHER_H

#include <stddef.h>
#include <stdint.h>

#include "base/alloc.h"

struct tsim;

struct ts_gather {
	/* entries of particle i: entry[first[i]] .. entry[first[i+1]-1]; an entry is 2 pair + side, side 1
	 * where i is the second particle of the pair */
	size_t *first;
	uint32_t *entry;
	size_t first_capacity, entry_capacity;
};

/* A list of n pairs: end[s][r * stride] is the column index of particle s of pair r (only local ones get
 * entries), tag[s][r * stride] its identity; or tag_of[index], if tag_of is not NULL. */
struct ts_gather_pairs {
	size_t n, stride;
	const int32_t *end[2], *tag[2], *tag_of;
};
enum ts_status ts_gather_index(const struct tsim *sim, struct ts_gather *gather,
			       const struct ts_gather_pairs *pairs);
void ts_gather_release(struct ts_gather *gather);

#endif
