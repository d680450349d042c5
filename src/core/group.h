/* Names of groups. A group is a set of particles with one bit; the column `mask` of particles
 * (particle/particles.h) has the bits of the groups of each particle. */
#ifndef TS_CORE_GROUP_H
#define TS_CORE_GROUP_H

#include <stdbool.h>

#include "base/words.h"

struct tsim;

enum { TS_MAX_GROUPS = 32 };

struct ts_groups {
	const char *name[TS_MAX_GROUPS]; /* by bit, owned by sim->pool; NULL: unused. name[0] is "all" */
	bool told_empty;		 /* an output of a group without particles has been warned of */
};

/* The bit of a group, or -1. */
int ts_group_find(const struct tsim *sim, const char *name);
/* The same, or an error with a suggestion. */
enum ts_status ts_group_require(struct tsim *sim, const struct ts_word *name, int *bit);
bool ts_group_exists(const struct tsim *sim, const char *name);
/* NULL: there is no group of that bit. */
const char *ts_group_name(const struct tsim *sim, int bit);
/* The bit of the group of that name, which is created if it does not exist. */
enum ts_status ts_group_make(struct tsim *sim, const char *name, const struct ts_place *where, int *bit);

#endif
