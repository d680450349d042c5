/* Search for the candidate pairs: particles that may touch before the next rebuild. */
#ifndef TS_NEIGH_CONTACT_SEARCH_H
#define TS_NEIGH_CONTACT_SEARCH_H

#include "base/alloc.h"
#include "neigh/cells.h"
#include "neigh/contact_list.h"
#include "particle/particles.h"

/* Pairs found by one share (one thread) of the search. Each begins on a cache line of its own, since threads write the
 * number of their pairs all the time. */
struct ts_contact_found {
	_Alignas(TS_CACHE_LINE) size_t from; /* range of its particles */
	size_t to;
	size_t first; /* index of its first pair in the contact list */
	/* partners of its particles, one particle after the other, each in the order of identities */
	int32_t *partner;
	size_t n, capacity;
	uint64_t *key, *spare; /* buffers for sorting partners */
	size_t key_capacity, spare_capacity;
	bool coincide; /* some partner may be coincident with its particle */
	enum ts_status status;
};

struct ts_contact_search {
	const struct tsim *sim;
	double skin;
	bool both_frozen;
	ts_excluded_fn *excluded; /* pairs to leave out, or NULL */
	size_t expected;	  /* number of pairs of the last search, to allocate memory */
	/* results, released by ts_contact_search_release */
	struct ts_contact_found *share;
	int shares;
	uint32_t *count; /* by local particle: number of pairs of which it is i */
	size_t n;	 /* number of all pairs */
	bool coincide;	 /* the particles of some pair may be coincident */

	struct ts_cells cells;
};

/* Zero-initialise what is not given. */
enum ts_status ts_contact_search(struct tsim *sim, struct ts_contact_search *search);
void ts_contact_search_release(struct ts_contact_search *search);

/* Which periodic image particle j is, as a number 0..26; see ts_image_code. */
static inline uint8_t ts_contact_image_of(const struct ts_particles *p, size_t j)
{
	return j < p->n ? (uint8_t)TS_IMAGE_SELF : ts_image_code(p->ghost_shift[j - p->n]);
}

#endif
