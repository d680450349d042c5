/* What the user reads while a script runs: the screen and the log file. */
#ifndef TS_BASE_LOG_H
#define TS_BASE_LOG_H

#include <stdbool.h>
#include <stdio.h>

#include "base/files.h"
#include "base/status.h"

enum ts_log_level { TS_LOG_TEXT, TS_LOG_WARNING, TS_LOG_PROGRESS };
typedef void ts_log_sink_fn(void *data, enum ts_log_level level, const char *text);

/* Either stream may be NULL. The log owns `file`, not `screen`. */
struct ts_log {
	struct ts_files *files; /* the door for the file; or NULL */
	FILE *screen, *file;
	bool echo_screen, echo_file; /* what `echo` says about input lines */
	bool progress;		     /* the screen is a terminal: show a progress line */
	bool progress_shown;	     /* a progress line now stands on the screen        */
	bool quiet;		     /* only warnings */
	int warnings;
	ts_log_sink_fn *sink; /* gets all that goes to the screen, screen or not; or NULL */
	void *sink_data;
	int trouble; /* errno of the first write that failed */
};

void ts_log(struct ts_log *log, const char *format, ...) __attribute__((format(printf, 2, 3)));
void ts_log_screen(struct ts_log *log, const char *format, ...) __attribute__((format(printf, 2, 3)));
void ts_log_file(struct ts_log *log, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* "file:line: warning: ..." on both. place may be NULL. */
void ts_warn(struct ts_log *log, const struct ts_place *place, const char *format, ...)
	__attribute__((format(printf, 3, 4)));
/* Overwrites the progress line of a terminal; an empty text removes it. */
void ts_log_progress(struct ts_log *log, const char *text);
/* Hands all to the system. */
enum ts_status ts_log_flush(struct ts_log *log, struct ts_error *err);
/* An error if something could not be written: a full disk, a reader of the screen that has gone. */
enum ts_status ts_log_check(const struct ts_log *log, struct ts_error *err);
/* An input line, to whom `echo` says. */
void ts_log_echo(struct ts_log *log, const char *line);

/* Opens the file for writing (or appending), closing the one before. path NULL: no file. */
enum ts_status ts_log_open(struct ts_log *log, struct ts_error *err, const struct ts_place *place,
			   const char *path, bool append);
/* Closes the file; a write that failed (disk full) is reported here at the latest. */
enum ts_status ts_log_close(struct ts_log *log, struct ts_error *err);

#endif
