/* Where particles of given identities are. */
#ifndef TS_PARTICLE_IDENTITY_H
#define TS_PARTICLE_IDENTITY_H

#include "particle/particles.h"

/* Valid until particles are added, deleted or reordered. */
struct ts_identities {
	const int32_t *row_of_tag; /* NULL: far more identities than particles, rows are searched */
	const int32_t *tag, *row;  /* those there are, in order */
	size_t n;
	int32_t max;
};

/* Rows by identity; with `ordered` also the list of all in the order of their identities. */
enum ts_status ts_identities(struct tsim *sim, bool ordered, struct ts_identities *out);

/* The row of a local particle, -1 if there is none of that identity. */
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
