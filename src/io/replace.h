/* Files that are complete or do not exist: written under a temporary name in the same folder, then
 * renamed. */
#ifndef TS_IO_REPLACE_H
#define TS_IO_REPLACE_H

#include <stdbool.h>
#include <stdio.h>

#include "core/sim.h"

/* Zero-initialise. */
struct ts_replace {
	FILE *file;		       /* NULL: not begun */
	struct ts_str path, temporary; /* final and temporary name */
	struct tsim *sim;
	struct ts_place where;
};

/* Creates PATH.tmp.<process>.<random>; temporary files that killed processes have left for the same path are
 * removed. With -explain the output is discarded. */
enum ts_status ts_replace_begin(struct ts_replace *r, struct tsim *sim, const struct ts_place *where,
				const char *path);
enum ts_status ts_replace_write(struct ts_replace *r, const void *bytes, size_t n);
/* Renames the file to its final name. `durable`: first waits until the data are on the disk, then until the
 * name is. On failure the old file is unchanged and the temporary one is removed. */
enum ts_status ts_replace_commit(struct ts_replace *r, bool durable);
/* Removes the temporary file. No effect after ts_replace_commit. */
void ts_replace_abandon(struct ts_replace *r);

#endif
