/* Creation of folders including their parents. */
#ifndef TS_BASE_MKDIRS_H
#define TS_BASE_MKDIRS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/files.h"

/* Creates the folder and its parents; 0 (also if it exists), or -1 and errno. */
int ts_mkdirs(struct ts_files *files, const char *path);
/* The same for the folder of a file. */
int ts_mkdirs_for(struct ts_files *files, const char *file);

/* Whether that is impossible: the nearest existing parent is not a folder or not writable; its path in
 * `by`. */
bool ts_mkdirs_blocked(struct ts_files *files, const char *file, char *by, size_t room);

#endif
