/* `tsim -check`: a script is gone through without running it, and all its errors are told at once.
 *
 * The interpreter works as with -explain (sim->reading.explain: nothing is stepped or written), but a line that
 * fails does not end it: its message is kept, the names it would have defined are remembered as lost, and
 * messages that only follow from that are left out. Runs, jumps and branches are recorded. Commands of
 * branches not taken and lines never reached are read as far as is possible without knowing what their
 * variables and names would stand for.
 *
 * Values that only a run can give are unknown (formula/unknown.h). Where a condition is unknown all
 * branches are gone through; a loop that ends by one, or that runs in many turns, is gone through until it
 * reaches no new lines. -explain goes the same way, but its first error ends it. */
#ifndef TS_SCRIPT_CHECK_H
#define TS_SCRIPT_CHECK_H

#include "base/map.h"
#include "script/internal.h"

enum ts_check_kind { TS_CHECK_STEP, TS_CHECK_RUN, TS_CHECK_WRITE };

/* Something a line does, however often. */
struct ts_check_event {
	struct ts_check_event *next;
	enum ts_check_kind kind;
	struct ts_place where;
	const char *what;
	int64_t count, step, steps; /* run: the first step, and how many in all */
	double dt;
	const char *hangs;     /* the value of a run that decides, or NULL */
	const char *path;      /* write: of the file */
	int64_t turns;	       /* jump: of a loop of which only some were gone through */
	size_t index;	       /* run: how many were before it */
	bool bounded, endless; /* not followed to its end; nothing seems to end it */
	bool open;	       /* run: its steps are not known; if: the condition is not */
	bool leaves;	       /* if: it may leave the lines around it */
	bool late;	       /* run: how many steps are before it is not known */
};

/* A run, as far as it was counted. */
struct ts_check_sum {
	int64_t count, steps;
};

/* Lines between a label and a jump back to it. */
struct ts_check_loop {
	struct ts_check_loop *next;
	const char *file;
	int from, to;
	int64_t turns; /* gone through since it began */
	bool open;     /* how many turns it takes is not known */
	/* as the last turn began */
	int64_t reached, nexts, branches, step;
	struct ts_total_cost cost;
	struct ts_check_sum *run;
	size_t nruns, run_capacity;
};

struct ts_check {
	struct ts_str errors; /* diagnostics, in order */
	int nerrors, unjudged;
	int open;     /* messages that may be there only because a value is not known */
	bool weak;    /* a line failed that later ones may build on: only what is wrong by itself counts */
	bool boxless; /* the box is one that was put in for a box that could not be made */
	bool placing; /* that one is being made */
	struct ts_map seen;    /* "file:line:column" of errors, "file:line" of lines run */
	struct ts_map lost;    /* "fix ID" that a failed line would have made */
	struct ts_map events;  /* by kind, place and text */
	struct ts_map guessed; /* "file:line" of lines with an unknown value, and the names they define */
	struct ts_check_event *first, **last;
	struct ts_check_loop *loop;
	size_t nruns;		/* events that are runs */
	int64_t reached;	/* lines so far */
	int64_t branches;	/* `if` so far */
	int64_t nexts;		/* `next` so far */
	int64_t turns_left;	/* that the last `next` has begun; 0: not known */
	const char *stepped[8]; /* the variables of the last `next` */
	int64_t jumps, runs;
	int alternatives; /* > 0: another branch was gone through before this one */
	size_t at;	  /* behind the last jump, in case its label is not found */
	int line;
	struct ts_arena arena;
};

/* Begins one, for -check and -explain. */
enum ts_status ts_check_new(struct ts_script *script);
void ts_check_free(struct ts_script *script);
/* check.c: a line that failed. TS_OK: go on with the next one. */
enum ts_status ts_check_recover(struct ts_script *script, const struct ts_line *line, struct ts_words words,
				enum ts_status status);
/* The message of sim->error is kept, if it is not a consequence of others, and cleared. */
enum ts_status ts_check_keep_error(struct ts_script *script, const char *remark);
/* The same, but -explain goes on only if the error may be there because a value is not known. */
enum ts_status ts_check_defer_error(struct ts_script *script, enum ts_status status);
/* A line with an unknown value is about to be run. */
enum ts_status ts_check_guess(struct ts_script *script, const struct ts_line *line, struct ts_words words);
/* What is not there any more, or may not be: messages that miss it are left out. */
enum ts_status ts_check_mark_lost(struct ts_script *script, const char *kind, const char *name);

/* check_trace.c */
enum ts_status ts_check_begin_line(struct ts_script *script, const struct ts_place *row);
enum ts_status ts_check_note(struct ts_script *script, enum ts_check_kind kind, const struct ts_place *where,
			     const char *hangs, struct ts_check_event **out, const char *format, ...)
	__attribute__((format(printf, 6, 7)));
enum ts_status ts_check_run(struct ts_script *script, const struct ts_place *where, int64_t steps);
/* A file that would be written or changed. */
enum ts_status ts_check_write(struct ts_script *script, const struct ts_place *where, const char *what,
			      const char *path);
/* Which of the branches of `if` was taken: the k-th word begins it; 0: none. */
enum ts_status ts_check_branch(struct ts_script *script, const struct ts_place *where, const char *which);

/* check_loop.c. *follow: whether to jump. */
enum ts_status ts_check_jump(struct ts_script *script, const struct ts_place *where, const char *file,
			     const char *label, bool *follow);
/* The jump that closes the loop is passed by. */
void ts_check_leave_loop(struct ts_script *script, const struct ts_place *where);
/* `next` has given these variables another value. */
void ts_check_next(struct ts_script *script, struct ts_words names);
/* The loop that a jump from here to the label closes; *out NULL: it goes forward, or elsewhere. */
enum ts_status ts_check_loop_of(struct ts_script *script, const struct ts_place *where, const char *file,
				const char *label, struct ts_check_loop **out);
/* How many turns it takes is not known from now on. */
void ts_check_open_loop(struct ts_script *script, struct ts_check_loop *loop);

/* check_branch.c: the branches of an `if` from the k-th word on, of which any may be the one. */
enum ts_status ts_check_branches(struct ts_script *script, struct ts_words words, size_t k,
				 const struct ts_place *where);

/* check_unreached.c: reads a command of a branch not taken, or a line never reached; or one that is to be
 * run later. */
enum ts_status ts_check_unreached(struct ts_script *script, const struct ts_line *line, const char *remark);
/* All commands of an `if`. */
enum ts_status ts_check_commands(struct ts_script *script, struct ts_words words);

#endif
