/* Other programs: found, started directly with their arguments (no shell), and waited for. */
#ifndef TS_BASE_PROCESS_H
#define TS_BASE_PROCESS_H

#include "base/status.h"
#include "base/str.h"

struct ts_process {
	const char *const *words; /* program and arguments, NULL-terminated; the program may be a path */
	const char *folder;	  /* working directory; NULL: the current one */
	const char *output;	  /* file for standard output and standard error */
	/* results */
	int status;	/* exit status, or 128 + signal number */
	double seconds; /* wall time */
};

/* Runs the program and waits for its end. Its standard input is empty. Returns an error only if it
 * could not be started. */
enum ts_status ts_process_run(struct ts_process *process, struct ts_error *err);

/* Path of a program as the shell would find it; false: not found. */
bool ts_process_find(const char *name, struct ts_str *path);
/* Path of the running program, or the name by which it was called. */
void ts_process_self(const char *called, struct ts_str *path);

#endif
