/* Slabs: planes of a field, one after the other in memory, of which each rank computes some beside each other. While it is
 * not active, each rank computes all of them. */
#ifndef TS_RANK_SLABS_H
#define TS_RANK_SLABS_H

#include "rank/world.h"

/* Zero-initialise: no ranks. ts_slabs_release when done. */
struct ts_slabs {
	struct ts_world *world;
	int n; /* number of planes */
	bool active;
	struct ts_parcel *out, *in; /* [ranks]: planes in fields, or packed bytes; `packed` if so. Owned */
	struct ts_parcel *packed;   /* [2 ranks], out and in */
};

enum ts_status ts_slabs_make(struct ts_slabs *slabs, struct ts_world *world, int n);
void ts_slabs_release(struct ts_slabs *slabs);

static inline int ts_slabs_ranks(const struct ts_slabs *slabs)
{
	return slabs && slabs->active ? slabs->world->n : 1;
}

/* The share of rank r of n things: from here to the one of rank r + 1. */
static inline size_t ts_slabs_part(const struct ts_slabs *slabs, int r, size_t n)
{
	return n * (size_t)r / (size_t)ts_slabs_ranks(slabs);
}

/* The things from .. to - 1 of n are those of this rank; slabs NULL or not active: all. */
static inline void ts_slabs_own(const struct ts_slabs *slabs, size_t n, size_t *from, size_t *to)
{
	const int rank = ts_slabs_ranks(slabs) > 1 ? slabs->world->rank : 0;

	*from = ts_slabs_part(slabs, rank, n);
	*to = ts_slabs_part(slabs, rank + 1, n);
}

/* Rows of `height` in each plane; the last rank has those of `more` further planes, too. */
static inline void ts_slabs_rows(const struct ts_slabs *slabs, int planes, int height, int more, long *from,
				 long *to)
{
	size_t first, end;

	ts_slabs_own(slabs, (size_t)planes, &first, &end);
	*from = (long)first * height;
	*to = (long)(end + (end == (size_t)planes ? (size_t)more : 0)) * height;
}

/* Planes of a field. */
struct ts_slabs_field {
	double *first; /* value of plane 0 */
	size_t stride; /* values from plane to plane */
	/* planes before plane 0, which are those of the first rank, and behind the last one, which are those of the last */
	int before, behind;
};

/* All ranks call them. Each gets the planes of all others. */
void ts_slabs_share(const struct ts_slabs *slabs, const struct ts_slabs_field *field);
/* Each gets the `below` planes below its own ones, and the `above` planes above them, as many as a slab has at most, from the
 * ranks beside it; `ring`: the last one is beside the first. */
void ts_slabs_share_beside(const struct ts_slabs *slabs, const struct ts_slabs_field *field, int below,
			   int above, bool ring);

#endif
