/* Access to files: all files are opened, created, moved, removed and inspected by these functions
 * (tests/door.sh). With -sandbox access is restricted ("closed"): only paths below the admitted folders
 * are allowed, with all links resolved. Functions set errno like the system calls. */
#ifndef TS_BASE_FILES_H
#define TS_BASE_FILES_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/stat.h>

#include "base/str.h"

enum { TS_MOST_FOLDERS = 8 };

/* A folder that is admitted in the sandbox, for reading or for writing. */
struct ts_files_root {
	char *path; /* path with all links resolved */
	int folder; /* open descriptor: all operations start there */
	bool writes;
};

struct ts_files_own;

/* Several processes that execute the same script: one of them writes, and all read what it reads. */
struct ts_files_peers {
	bool first; /* this is the one that reads and writes */
	/* Copies the bytes of the first one to all; called by all in the same order. */
	void (*spread)(void *data, void *bytes, size_t n);
	/* Ends all: this process has called another function of files than the first one. */
	void (*astray)(void *data, const char *called);
	void *data;
};

/* Zero-initialise: no restriction. All functions take NULL for unrestricted access. */
struct ts_files {
	bool closed;
	struct ts_files_root root[TS_MOST_FOLDERS];
	int n;
	int64_t most, written;	  /* limit and sum of bytes written; each new file or folder counts as well */
	struct ts_files_own *own; /* files that were written in the sandbox: they may be read again */
	size_t nown, own_capacity;
	char why[512];			    /* reason of the last refusal */
	const struct ts_files_peers *peers; /* NULL: this process is alone */
	volatile const int *stop;	    /* not 0: long reads are to be aborted; NULL: never */
	struct ts_script_folder *script;    /* [nscripts], those opened so far; base/script_folders.h */
	size_t nscripts, script_capacity;
};

/* Admits a folder in the sandbox; -1 and errno if it does not exist. */
int ts_files_admit(struct ts_files *files, const char *folder, bool writes);
void ts_files_close(struct ts_files *files, int64_t most_bytes);
bool ts_files_closed(const struct ts_files *files);
void ts_files_release(struct ts_files *files);

bool ts_files_stopped(const struct ts_files *files);
/* Reason of the last failure, from errno or the sandbox. */
const char *ts_files_why(const struct ts_files *files);

/* Like fopen with r, w, a; x behind w: the file must not exist, not even as a link. */
FILE *ts_files_open(struct ts_files *files, const char *path, const char *mode);
/* A file to read, of which no process has a copy: all of them read the same bytes in the same order. */
FILE *ts_files_open_along(struct ts_files *files, const char *path);
/* Whether several processes read the same files. */
bool ts_files_shared(const struct ts_files *files);
void *ts_files_open_gz(struct ts_files *files, const char *path); /* gzFile, to read */
/* The same; a file that does not exist is looked for in the folder of `script`, too (NULL: none). */
void *ts_files_open_gz_of(struct ts_files *files, const char *path, const char *script);
FILE *ts_files_open_null(void);						       /* /dev/null */
void *ts_files_list(struct ts_files *files, const char *folder);	       /* DIR */
int ts_files_stat(struct ts_files *files, const char *path, struct stat *out); /* stat */
/* Whether the last component is a symbolic link, or the path cannot be resolved. */
bool ts_files_is_link(const struct ts_files *files, const char *path);
/* Bytes of a regular file that was opened to be written; -1: none, as a device or a stream of the sandbox. */
int64_t ts_files_length(const struct ts_files *files, FILE *file);
/* Whether files may be created in the folder by its permissions; the sandbox may still refuse. */
bool ts_files_may_make_in(const struct ts_files *files, const char *folder);
int ts_files_make_folder(struct ts_files *files, const char *path);
int ts_files_remove(struct ts_files *files, const char *path);
int ts_files_remove_folder(struct ts_files *files, const char *path);
int ts_files_move(struct ts_files *files, const char *from, const char *to);
int ts_files_chdir(struct ts_files *files, const char *folder); /* chdir */
/* fsync; the file must have been flushed */
int ts_files_sync(struct ts_files *files, const char *path, FILE *file);
int ts_files_sync_folder(struct ts_files *files, const char *folder);
double ts_files_free_space(struct ts_files *files, const char *path); /* bytes; -1: errno */

/* Resolves all links, `.` and `..` of a path; components that do not exist yet are appended as they
 * are. */
int ts_files_resolve(const char *path, struct ts_str *out);
/* The same, but a link as the last component is not followed. */
int ts_files_resolve_name(const char *path, struct ts_str *out);
bool ts_files_below(const char *path, const char *folder);

#endif
