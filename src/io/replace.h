/* Files that appear whole or not at all: written beside their place, then renamed into it. */
#ifndef TS_IO_REPLACE_H
#define TS_IO_REPLACE_H

#include <stdbool.h>
#include <stdio.h>

#include "core/sim.h"

/* Zero-initialise. */
struct ts_replace {
	FILE *file;
	struct ts_str path, temporary;
	struct tsim *sim;
	struct ts_place where;
};

/* Opens PATH.tmp.<process>.<random>, which is not there yet; what killed processes have left of the same
 * file is removed. With -explain all goes nowhere. */
enum ts_status ts_replace_begin(struct ts_replace *r, struct tsim *sim, const struct ts_place *where,
				const char *path);
enum ts_status ts_replace_write(struct ts_replace *r, const void *bytes, size_t n);
/* Puts the file in its place. `durable`: waits until it is on the disk, and after
 * that its name too. On failure the old
 * file is untouched and the temporary one gone. */
enum ts_status ts_replace_commit(struct ts_replace *r, bool durable);
/* Forgets what was written. Harmless after commit. */
void ts_replace_abandon(struct ts_replace *r);

#endif
