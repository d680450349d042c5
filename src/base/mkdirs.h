/* Folders with all that leads to them. */
#ifndef TS_BASE_MKDIRS_H
#define TS_BASE_MKDIRS_H

/* Makes the folder with all that leads to it; 0, also where it is there already, or -1 and errno. */
int ts_mkdirs(const char *path);
/* The same for the folder that the file is to be in. */
int ts_mkdirs_for(const char *file);

#endif
