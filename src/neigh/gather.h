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

/* A list of pairs: of the r-th, the ends in the particle columns (local ones are listed) and their identities
 * stand at r * stride. */
struct ts_gather_pairs {
	size_t n, stride;
	const int32_t *end[2], *tag[2];
};
enum ts_status ts_gather_index(const struct tsim *sim, struct ts_gather *gather,
			       const struct ts_gather_pairs *pairs);
void ts_gather_release(struct ts_gather *gather);

#endif
