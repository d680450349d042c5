/* Files of several processes that execute the same script: base/files.h. All functions are called by all of them, in
 * the same order, and return the same result and errno. */
#ifndef TS_BASE_FILES_PEERS_H
#define TS_BASE_FILES_PEERS_H

#include "base/files.h"

static inline bool ts_peers(const struct ts_files *files)
{
	return files && files->peers;
}

/* The result of the first one, and its errno. `called`: what all call now; a process that calls something else ends all. */
int ts_peers_agree(const struct ts_files_peers *peers, const char *called, int result);
/* The same; if the result is 0, all get the bytes of the first one as well. */
int ts_peers_agree_on(const struct ts_files_peers *peers, const char *called, int result, void *bytes,
		      size_t n);
/* The first one opens the file. The others get a copy of its bytes, or what they write is discarded. */
FILE *ts_peers_open(const struct ts_files_peers *peers, const char *path, const char *mode);
/* A file to read, without a copy: the first one passes on what all read at a time. */
FILE *ts_peers_open_along(const struct ts_files_peers *peers, const char *path);
/* Of a file to read; -1. */
int ts_peers_descriptor(const struct ts_files_peers *peers, const char *path);
/* All that the first one reads from the descriptor; closes it. The others pass -1. */
int ts_peers_copy(const struct ts_files_peers *peers, int from);
int ts_peers_stat(const struct ts_files_peers *peers, const char *path, struct stat *out);

/* What the first one does alone, as with a library or a program that writes the file: the functions of base/files.h that `act`
 * calls are then those of one process. All get its result. */
int ts_peers_by_first(struct ts_files *files, int (*act)(void *data), void *data);
/* The same by the caller alone: the others do not call it. */
int ts_peers_apart(struct ts_files *files, int (*act)(void *data), void *data);

#endif
