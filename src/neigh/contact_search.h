/* Search for the pairs of particles that may touch before the next rebuild. */
#ifndef TS_NEIGH_CONTACT_SEARCH_H
#define TS_NEIGH_CONTACT_SEARCH_H

#include "neigh/cells.h"
#include "neigh/contact_list.h"
#include "particle/particles.h"

/* What one share of the particles has found. */
struct ts_contact_found {
	size_t from, to;  /* these particles */
	size_t first;	  /* number of its first row among all */
	int32_t *partner; /* of its particles in turn, in the order of identities */
	size_t n, capacity;
	uint64_t *key, *spare; /* to sort partners */
	size_t key_capacity, spare_capacity;
	bool coincide; /* some may be at the same place as their particle */
	enum ts_status status;
};

struct ts_contact_search {
	const struct tsim *sim;
	double skin;
	bool both_frozen;
	ts_excluded_fn *excluded; /* or NULL */
	size_t expected;	  /* rows, so many as last time */
	/* results, to be released */
	struct ts_contact_found *share;
	int shares;
	uint32_t *count; /* of each particle: how many of its partners make rows with it as the first */
	size_t n;	 /* rows in all */
	bool coincide;	 /* of some of them the partners may be at the same place */

	struct ts_cells cells;
};

enum ts_status ts_contact_search(struct tsim *sim, struct ts_contact_search *search);
void ts_contact_search_release(struct ts_contact_search *search);

/* Which image of j there is, as a number 0..26. */
static inline uint8_t ts_contact_image(const struct ts_particles *p, size_t j)
{
	return j < p->n ? (uint8_t)TS_IMAGE_SELF : ts_image_code(p->ghost_shift[j - p->n]);
}

#endif
