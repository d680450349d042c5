/* Other programs: found, started with their arguments as they are (no shell), waited for. */
#ifndef TS_BASE_PROCESS_H
#define TS_BASE_PROCESS_H

#include "base/status.h"
#include "base/str.h"

struct ts_process {
	const char *const *words; /* program and arguments, closed by NULL; the program may be a path */
	const char *folder;	  /* where it runs; NULL: here */
	const char *output;	  /* the file that gets all it prints */
	/* how it ended */
	int status;	/* exit status, or 128 + the number of the signal */
	double seconds; /* wall time */
};

/* Runs it to its end. Its standard input is empty. An error only if it could not be started. */
enum ts_status ts_process_run(struct ts_process *process, struct ts_error *err);

/* Where a program of this name is, as the shell would find it; false: nowhere. */
bool ts_process_find(const char *name, struct ts_str *path);
/* The file of the program that runs now, or what it was called. */
void ts_process_self(const char *called, struct ts_str *path);

#endif
