/* Groups as all know them: named sets of particles, a bit for each. Which particles are in a group is a
 * column of particles: particle/particles.h. */
#ifndef TS_CORE_GROUP_H
#define TS_CORE_GROUP_H

#include <stdbool.h>

#include "base/words.h"

struct tsim;

enum { TS_MAX_GROUPS = 32 };

struct ts_groups {
	const char *name[TS_MAX_GROUPS]; /* by bit, of the string pool; NULL: free. name[0] is "all" */
};

/* The bit of a group, or -1. */
int ts_group_find(const struct tsim *sim, const char *name);
/* The same, or an error with a suggestion. */
enum ts_status ts_group_require(struct tsim *sim, const struct ts_word *name, int *bit);
bool ts_group_exists(const struct tsim *sim, const char *name);
/* NULL: there is no group of that bit. */
const char *ts_group_name(const struct tsim *sim, int bit);
/* The bit of the group of that name, which is made if there is none. */
enum ts_status ts_group_make(struct tsim *sim, const char *name, const struct ts_place *where, int *bit);

#endif
