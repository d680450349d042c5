/* State by particle outside of its columns, such as the history of its contacts: rows that move with the particle
 * when it changes to another rank. */
#ifndef TS_CORE_CARRIED_H
#define TS_CORE_CARRIED_H

#include <stddef.h>
#include <stdint.h>

#include "rank/world.h"

struct tsim;
struct ts_instance;

/* Rows of the same size, each with the identity of its particle before it. */
struct ts_carried {
	size_t bytes; /* of a row, without the identity */
	struct ts_parcel rows;
};

enum { TS_LEAVING_WORDS = 512 };

/* Identities, in ascending order, of the particles that go to other ranks. */
struct ts_leaving {
	int32_t *tag;
	size_t n;
	uint64_t some[TS_LEAVING_WORDS]; /* each as the bit of its remainder: most others are told by it */
};

/* When all identities are there. */
void ts_carried_sort(struct ts_leaving *leaving);

/* False of most particles that stay; without branches. */
static inline bool ts_carried_may_leave(const struct ts_leaving *leaving, int32_t tag)
{
	return leaving->some[(uint32_t)tag / 64 % TS_LEAVING_WORDS] >> (tag & 63) & 1;
}

bool ts_carried_leaves(const struct ts_leaving *leaving, int32_t tag);

struct ts_carrier {
	/* Appends all rows and removes them from the state; with `leaving` only those of these particles, and the
	 * state may keep all. `results`: with the forces of the last step, for outputs. */
	enum ts_status (*give)(struct ts_instance *self, struct tsim *sim, bool results,
			       const struct ts_leaving *leaving, struct ts_carried *out);
	/* Takes the rows of the local particles, in addition to those that it has. */
	enum ts_status (*take)(struct ts_instance *self, struct tsim *sim, const struct ts_carried *rows);
	/* Contacts of two particles: appends the rows of those one of whose particles crosses a periodic face, once with each
	 * identity; the state keeps all. NULL: rows do not depend on periodic faces. */
	enum ts_status (*turn)(struct ts_instance *self, struct tsim *sim, const struct ts_leaving *turning,
			       struct ts_carried *out);
};

/* Appends a row of out->bytes bytes, which the caller writes; NULL: out of memory. */
unsigned char *ts_carried_add(struct ts_carried *out, int32_t tag);
size_t ts_carried_count(const struct ts_carried *rows);
/* Row k; its particle. */
const unsigned char *ts_carried_row(const struct ts_carried *rows, size_t k, int32_t *tag);

#endif
