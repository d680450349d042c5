/* Groups as the core sees them: named sets of particles, kept by the particles system, which
 * defines these functions. */
#ifndef TS_CORE_GROUP_H
#define TS_CORE_GROUP_H

#include <stdbool.h>

#include "base/words.h"

struct tsim;

/* The bit of an existing group, or an error with a suggestion. */
enum ts_status ts_group_require(struct tsim *sim, const struct ts_word *name, int *bit);
bool ts_group_exists(const struct tsim *sim, const char *name);
const char *ts_group_name(const struct tsim *sim, int bit);

#endif
