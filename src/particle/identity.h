/* Lookup of the local index of a particle by its tag (atom ID). */
#ifndef TS_PARTICLE_IDENTITY_H
#define TS_PARTICLE_IDENTITY_H

#include "particle/particles.h"

/* Valid until particles are added, deleted or reordered. */
struct ts_identities {
	const int32_t *row_of_tag; /* [max + 1], -1: no such particle; NULL: use the sorted list */
	const int32_t *tag, *row;  /* [n], tags in ascending order and their local indices; may be NULL */
	size_t n;
	int32_t max; /* largest tag ever assigned */
};

/* Makes the lookup; with `ordered` the sorted list, too. The arrays belong to the particles. */
enum ts_status ts_identities(struct tsim *sim, bool ordered, struct ts_identities *out);

/* The local index of the particle with this tag, or -1. */
static inline int32_t ts_identity_row(const struct ts_identities *map, int64_t tag)
{
	size_t lo = 0, hi = map->n;

	if (tag < 1 || tag > map->max)
		return -1;
	if (map->row_of_tag)
		return map->row_of_tag[tag];
	while (lo < hi) {
		size_t middle = lo + (hi - lo) / 2;

		if (map->tag[middle] < tag)
			lo = middle + 1;
		else
			hi = middle;
	}
	return lo < map->n && map->tag[lo] == tag ? map->row[lo] : -1;
}

#endif
