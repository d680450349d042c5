/* Folders with all that leads to them. */
#ifndef TS_BASE_MKDIRS_H
#define TS_BASE_MKDIRS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/files.h"

/* Makes the folder with all that leads to it; 0, also where it is there already, or -1 and errno. */
int ts_mkdirs(struct ts_files *files, const char *path);
/* The same for the folder that the file is to be in. */
int ts_mkdirs_for(struct ts_files *files, const char *file);

/* Whether that could not be: the nearest of its folders that is there is none, or is closed. */
bool ts_mkdirs_blocked(struct ts_files *files, const char *file, char *by, size_t room);

#endif
