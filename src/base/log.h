/* Output to the user while a script runs: screen and log file. */
#ifndef TS_BASE_LOG_H
#define TS_BASE_LOG_H

#include <stdbool.h>
#include <stdio.h>

#include "base/files.h"
#include "base/status.h"
#include "base/str.h"

enum ts_log_level { TS_LOG_TEXT, TS_LOG_WARNING, TS_LOG_PROGRESS, TS_LOG_SETTING };
typedef void ts_log_sink_fn(void *data, enum ts_log_level level, const char *text);
typedef bool ts_log_doubt_fn(void *data, const struct ts_place *place);

/* Either stream may be NULL. The log closes `file`, not `screen`. */
struct ts_log {
	struct ts_files *files; /* access control of files; or NULL */
	FILE *screen, *file;
	bool echo_screen, echo_file; /* whether input lines are echoed (command echo) */
	bool progress;		     /* the screen is a terminal: show a progress line */
	double patience;	     /* seconds without other output after which a run shows it */
	double spoke;		     /* ts_clock() of the last other output, s */
	bool seldom;		     /* there were `patience` seconds before that */
	bool progress_shown;	     /* a progress line is shown on the screen */
	bool quiet;		     /* print warnings only */
	int warnings;
	bool withholds; /* -check: warnings are counted in `withheld` instead, since they may follow from unknown values */
	int withheld;
	ts_log_doubt_fn
		*doubts; /* -check, -explain: whether warnings at a place are withheld, too; or NULL */
	void *doubts_data;
	struct ts_str *warned; /* gets the lines of warnings, too; or NULL */
	ts_log_sink_fn *sink;  /* callback that gets all screen output, even without a screen; or NULL */
	void *sink_data;
	/* Callback that gets a copy of what is printed to the screen, of warnings and of settings: the report of a
	 * run; or NULL. */
	ts_log_sink_fn *copy;
	void *copy_data;
	int trouble; /* errno of the first failed write */
};

void ts_log(struct ts_log *log, const char *format, ...) __attribute__((format(printf, 2, 3)));
void ts_log_screen(struct ts_log *log, const char *format, ...) __attribute__((format(printf, 2, 3)));
void ts_log_file(struct ts_log *log, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Whether settings are recorded, in the log file or the copy; writes a line with settings there. */
bool ts_log_wants_settings(const struct ts_log *log);
void ts_log_setting(struct ts_log *log, const char *line);
/* Prints "file:line: warning: ..." to screen and log. place may be NULL. */
void ts_warn(struct ts_log *log, const struct ts_place *place, const char *format, ...)
	__attribute__((format(printf, 3, 4)));
/* Prints an error that ends the program to standard error and to the log file, which is complete afterwards. */
void ts_log_fatal(struct ts_log *log, const char *text);
/* Replaces the progress line of a terminal; an empty text removes it. */
void ts_log_progress(struct ts_log *log, const char *text);
/* Whether a run shows its progress now: on a terminal, where nothing else has been printed for a while or is
 * printed only at long intervals. */
bool ts_log_shows_progress(const struct ts_log *log);
/* Columns of the terminal; 80 if not known. */
int ts_log_width(const struct ts_log *log);
/* Flushes both streams. */
enum ts_status ts_log_flush(struct ts_log *log, struct ts_error *err);
/* Returns an error if a write has failed: disk full, or the reader of the screen has closed it. */
enum ts_status ts_log_check(const struct ts_log *log, struct ts_error *err);
/* Prints an input line to the streams selected by the command echo. */
void ts_log_echo(struct ts_log *log, const char *line);

/* Opens the log file for writing (or appending) and closes the previous one. path NULL: no file. */
enum ts_status ts_log_open(struct ts_log *log, struct ts_error *err, const struct ts_place *place,
			   const char *path, bool append);
/* Closes the log file; failed writes (disk full) are reported here at the latest. */
enum ts_status ts_log_close(struct ts_log *log, struct ts_error *err);

#endif
