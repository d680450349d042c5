/* Status codes, and the error message of a simulation.
 *
 * Every function that can fail returns an enum ts_status and stores the *first* message, with the place
 * in the script that caused it, in the struct ts_error of its context. Nothing below main.c prints an
 * error or exits. */
#ifndef TS_BASE_STATUS_H
#define TS_BASE_STATUS_H

#include <stdarg.h>
#include <stdbool.h>

/* clang-format off */
#define TS_STATUS_LIST(X)                                                                          \
	X(OK, "success")                                                                           \
	X(SYNTAX, "syntax error")                                                                  \
	X(UNKNOWN, "unknown name")                                                                 \
	X(RANGE, "value out of range")                                                             \
	X(STATE, "not possible now")                                                               \
	X(IO, "input or output failed")                                                            \
	X(DAMAGED, "damaged file")                                                                 \
	X(NOMEM, "out of memory")                                                                  \
	X(PHYSICS, "the simulation left its valid region")                                         \
	X(STOPPED, "stopped on request")
/* clang-format on */

#define TS_STATUS_ENUM(name, text) TS_##name,
enum ts_status { TS_STATUS_LIST(TS_STATUS_ENUM) TS_NSTATUS };
#undef TS_STATUS_ENUM

/* Part of one line of a script. The strings belong to the string pool of the simulation. line == 0:
 * unknown place; column == 0: the whole line. */
struct ts_place {
	const char *file;	  /* file name as given by the user, "stdin", "-var" ... */
	const char *text;	  /* the line before substitution of variables */
	int line, column, length; /* all counted from 1                     */
};

/* Of another place than that of the error, for "%s:%d". */
#define TS_FILE_AND_LINE(place) ((place).file ? (place).file : "command"), (place).line

struct ts_error {
	enum ts_status status;
	struct ts_place place;
	const char *source; /* C file and line of the report, for developers */
	int source_line;
	char message[1024];
	char missing[96]; /* the missing object, e.g. "compute total"; "": none */
	bool conflict;	  /* ts_conflict */
};

/* Stores the message unless there is one already, and returns the code: `return ts_fail(&sim->error,
 * TS_RANGE, &word->place, "...", ...);`. place may be NULL. */
#define ts_fail(err, code, place, ...) ts_fail_at(err, code, place, __FILE__, __LINE__, __VA_ARGS__)
/* TS_UNKNOWN: there is no object of this kind (variable, fix, group ...) with this name. */
#define ts_missing(err, kind, name, place, ...) \
	ts_missing_at(err, kind, name, place, __FILE__, __LINE__, __VA_ARGS__)
enum ts_status ts_missing_at(struct ts_error *err, const char *kind, const char *name,
			     const struct ts_place *place, const char *source, int source_line,
			     const char *format, ...) __attribute__((format(printf, 7, 8)));
/* TS_STATE: definitions exclude each other (a second region of that name, deletion of what is in use), whatever the
 * numbers of the script are: -check reports it behind unknown values, too. */
#define ts_conflict(err, place, ...) ts_conflict_at(err, place, __FILE__, __LINE__, __VA_ARGS__)
enum ts_status ts_conflict_at(struct ts_error *err, const struct ts_place *place, const char *source,
			      int source_line, const char *format, ...) __attribute__((format(printf, 5, 6)));
enum ts_status ts_fail_at(struct ts_error *err, enum ts_status code, const struct ts_place *place,
			  const char *source, int source_line, const char *format, ...)
	__attribute__((format(printf, 6, 7)));
enum ts_status ts_vfail_at(struct ts_error *err, enum ts_status code, const struct ts_place *place,
			   const char *source, int source_line, const char *format, va_list args)
	__attribute__((format(printf, 6, 0)));

#define ts_nomem(err) ts_fail(err, TS_NOMEM, NULL, "out of memory")

void ts_error_clear(struct ts_error *err);
const char *ts_status_text(enum ts_status status);

#define TS_TRY(expr)                                   \
	do {                                           \
		enum ts_status ts_try_status = (expr); \
		if (ts_try_status != TS_OK)            \
			return ts_try_status;          \
	} while (0)

#endif
