/* Other programs: found, started directly with their arguments (no shell), and waited for. */
#ifndef TS_BASE_PROCESS_H
#define TS_BASE_PROCESS_H

#include <stdbool.h>
#include <sys/types.h>

#include "base/status.h"
#include "base/str.h"

struct ts_process {
	const char *const *words; /* program and arguments, NULL-terminated; the program may be a path */
	const char *folder;	  /* working directory; NULL: the current one */
	const char *output;	  /* file for standard output and standard error */
	bool apart;		  /* in a process group of its own */
	bool follows;		  /* it is terminated when this process is killed, where Linux does that */
	/* while it runs */
	pid_t child;  /* 0: it does not run */
	double begin; /* ts_clock at the start */
	/* results */
	int status;	/* exit status, or 128 + signal number */
	double seconds; /* wall time */
};

/* Starts the program. Its standard input is empty. */
enum ts_status ts_process_start(struct ts_process *process, struct ts_error *err);
/* Whether the program has ended; if so, the results are set. */
bool ts_process_ended(struct ts_process *process);
void ts_process_signal(const struct ts_process *process, int number);

/* Runs the program and waits for its end. Returns an error only if it could not be started. */
enum ts_status ts_process_run(struct ts_process *process, struct ts_error *err);

/* A program that runs beside this one and reads from its standard input what is written to it. It is in a process group
 * of its own, so that it ends by the end of its input, not by an interrupt from the terminal. */
struct ts_feed {
	pid_t child; /* 0: none */
	int socket;
	char said[400]; /* the end of what the program has printed, without control characters */
};

/* Starts the program (words as in struct ts_process). 0, or errno: ENOENT if there is none. */
int ts_feed_start(struct ts_feed *feed, const char *const *words);
/* Waits while the program is busy. 0, or errno: EPIPE if the program has ended. Never raises SIGPIPE. */
int ts_feed_write(struct ts_feed *feed, const void *bytes, size_t n);
/* Ends the input, waits for the program; its exit status, or 128 + signal number. Without a program 0. */
int ts_feed_end(struct ts_feed *feed);
/* Kills the program. */
void ts_feed_kill(struct ts_feed *feed);

/* Path of a program as the shell would find it; false: not found. */
bool ts_process_find(const char *name, struct ts_str *path);
/* Path of the running program, or the name by which it was called. */
void ts_process_self(const char *called, struct ts_str *path);

#endif
