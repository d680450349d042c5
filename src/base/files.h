/* The one door to files: whoever opens, makes, moves, removes or looks at a path does it here
 * (tests/house/door.sh). It stands open until it is closed for -sandbox; then it lets through only what lies
 * below the folders that it was given, all links resolved. Functions set errno as the calls of the system
 * do. */
#ifndef TS_BASE_FILES_H
#define TS_BASE_FILES_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/stat.h>

#include "base/str.h"

enum { TS_MOST_FOLDERS = 8 };

/* One folder that a closed door opens: for reading, or for writing. */
struct ts_files_root {
	char *path; /* resolved */
	int folder; /* open: what is done begins there */
	bool writes;
};

struct ts_files_own;

/* Zero-initialise: open. All functions take NULL for an open one. */
struct ts_files {
	bool closed;
	struct ts_files_root root[TS_MOST_FOLDERS];
	int n;
	int64_t most, written;	  /* bytes; what a file or folder takes by itself counts as well */
	struct ts_files_own *own; /* files that were written through here: they can be read again */
	size_t nown, own_capacity;
	char why[512];		  /* the last refusal */
	volatile const int *stop; /* not 0: whoever reads for long shall end; NULL: never */
};

/* Lets a closed door open this folder; -1 and errno where there is no such folder. */
int ts_files_admit(struct ts_files *files, const char *folder, bool writes);
void ts_files_close(struct ts_files *files, int64_t most_bytes);
bool ts_files_closed(const struct ts_files *files);
void ts_files_release(struct ts_files *files);

bool ts_files_stopped(const struct ts_files *files);
/* The reason of the last failure, from errno and the door. */
const char *ts_files_why(const struct ts_files *files);

/* As fopen: r, w, a; x behind w: the file must not be there, not even as a link. */
FILE *ts_files_open(struct ts_files *files, const char *path, const char *mode);
void *ts_files_open_gz(struct ts_files *files, const char *path);	       /* gzFile, to read */
FILE *ts_files_nowhere(void);						       /* swallows what is written */
void *ts_files_list(struct ts_files *files, const char *folder);	       /* DIR */
int ts_files_look(struct ts_files *files, const char *path, struct stat *out); /* stat */
/* Whether the rights of the folder let files be made in it; a closed door may still refuse. */
bool ts_files_may_make_in(const struct ts_files *files, const char *folder);
int ts_files_make_folder(struct ts_files *files, const char *path);
int ts_files_remove(struct ts_files *files, const char *path);
int ts_files_remove_folder(struct ts_files *files, const char *path);
int ts_files_move(struct ts_files *files, const char *from, const char *to);
int ts_files_enter(struct ts_files *files, const char *folder);		 /* chdir */
int ts_files_sync(struct ts_files *files, const char *path, FILE *file); /* that was flushed */
int ts_files_sync_folder(struct ts_files *files, const char *folder);
double ts_files_free_space(struct ts_files *files, const char *path); /* bytes; -1: errno */

/* The path with all links, `.` and `..` resolved; what is not there yet is added as it is. */
int ts_files_resolve(const char *path, struct ts_str *out);
/* The same of what the name itself stands for: a link at the end is not followed. */
int ts_files_resolve_name(const char *path, struct ts_str *out);
bool ts_files_below(const char *path, const char *folder);

#endif
