/* `tsim -check`: a script is gone through without running it, and all its errors are told at once.
 *
 * The interpreter works as with -explain (sim->explain: nothing is stepped or written), but a line that
 * fails does not end it: its message is kept, the names it would have defined are remembered as lost, and
 * messages that only follow from that are left out. Runs, jumps and branches are recorded. Commands of
 * branches not taken and lines never reached are read as far as is possible without knowing what their
 * variables and names would stand for. */
#ifndef TS_SCRIPT_CHECK_H
#define TS_SCRIPT_CHECK_H

#include "base/map.h"
#include "script/interpreter.h"

enum ts_check_kind { TS_CHECK_STEP, TS_CHECK_RUN, TS_CHECK_WRITE };

/* Something a line does, however often. */
struct ts_check_event {
	struct ts_check_event *next;
	enum ts_check_kind kind;
	struct ts_place where;
	const char *what;
	int64_t count, step, steps; /* run: the first step, and how many in all */
	double dt;
	const char *hangs; /* the value of a run that decides, or NULL */
	int64_t hanging, nexts; /* of the check, when it was last met */
	bool bounded, endless; /* not followed to its end; nothing seems to end it */
};

struct ts_check {
	struct ts_str errors; /* diagnostics, in order */
	int nerrors, unjudged;
	bool weak;  /* a line failed that later ones may build on: only what is wrong by itself counts */
	bool boxless; /* the box is one that was put in for a box that could not be made */
	bool placing; /* that one is being made */
	struct ts_map seen;    /* "file:line:column" of errors, "file:line" of lines run */
	struct ts_map lost;    /* "fix ID" that a failed line would have made */
	struct ts_map made;    /* directories that the script makes */
	struct ts_map events;  /* by kind, place and text */
	struct ts_check_event *first, **last;
	int64_t hanging;       /* branches so far that hang on a run */
	int64_t nexts;	       /* `next` so far */
	int64_t jumps;
	size_t at;	       /* behind the last jump, in case its label is not found */
	int line;
	struct ts_arena arena;
};

void ts_check_free(struct ts_script *script);
/* check.c: a line that failed. TS_OK: go on with the next one. */
enum ts_status ts_check_recover(struct ts_script *script, const struct ts_line *line,
				struct ts_words words, enum ts_status status);
/* The message of sim->error is kept, if it is not a consequence of others, and cleared. */
enum ts_status ts_check_keep_error(struct ts_script *script, const char *remark);

/* check_trace.c */
enum ts_status ts_check_begin_line(struct ts_script *script, const struct ts_place *row);
enum ts_status ts_check_note(struct ts_script *script, enum ts_check_kind kind,
			     const struct ts_place *where, const char *hangs,
			     struct ts_check_event **out, const char *format, ...)
	__attribute__((format(printf, 6, 7)));
enum ts_status ts_check_run(struct ts_script *script, const struct ts_place *where, int64_t steps);
/* A file that would be written or changed. */
enum ts_status ts_check_write(struct ts_script *script, const struct ts_place *where,
			      const char *what, const char *path);
/* Which of the branches of `if` was taken: the k-th word begins it; 0: none. */
enum ts_status ts_check_branch(struct ts_script *script, const struct ts_place *where,
			       const char *which);
/* *follow: whether to jump. Loops that only a run would end are gone through twice. */
enum ts_status ts_check_jump(struct ts_script *script, const struct ts_place *where,
			     const char *file, const char *label, bool *follow);

/* check_unreached.c: reads a command of a branch not taken, or a line never reached. */
enum ts_status ts_check_unreached(struct ts_script *script, const struct ts_line *line,
				  const char *remark);
/* All commands of an `if`. */
enum ts_status ts_check_commands(struct ts_script *script, struct ts_words words);

#endif
