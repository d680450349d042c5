/* Folders with all that leads to them. */
#ifndef TS_BASE_MKDIRS_H
#define TS_BASE_MKDIRS_H

#include "base/files.h"

/* Makes the folder with all that leads to it; 0, also where it is there already, or -1 and errno. */
int ts_mkdirs(struct ts_files *files, const char *path);
/* The same for the folder that the file is to be in. */
int ts_mkdirs_for(struct ts_files *files, const char *file);

#endif
