/* `tsim -check`: reads a script without running the simulation and reports all its errors at once.
 *
 * Commands are executed as with -explain (sim->reading.explain: nothing is stepped or written), but a line
 * that fails does not end the script: its message is recorded, the names that it would have defined are
 * marked as lost, and messages that only follow from that are left out. Runs, jumps and branches are
 * recorded. Commands of branches not taken and lines never reached are parsed as far as that is possible
 * without the values of variables.
 *
 * Values that only a run can give are unknown (formula/unknown.h). If a condition is unknown, all branches
 * are executed. A loop whose end depends on an unknown condition, or which has many iterations, is
 * executed until it reaches no new lines. -explain reads scripts in the same way, but its first error ends
 * the script. */
#ifndef TS_SCRIPT_CHECK_H
#define TS_SCRIPT_CHECK_H

#include "base/map.h"
#include "script/internal.h"

enum ts_check_kind { TS_CHECK_STEP, TS_CHECK_RUN, TS_CHECK_WRITE };

/* An action of a script line, recorded once, however often it is executed. */
struct ts_check_event {
	struct ts_check_event *next;
	enum ts_check_kind kind;
	struct ts_place where;
	const char *what;	/* text for the report */
	int64_t count;		/* how often it was executed */
	int64_t step, steps;	/* run: the first step; the steps of all its executions */
	double dt;		/* run: time step [time] */
	const char *depends_on; /* name of the unknown value on which it depends, or NULL */
	const char *path;	/* write: of the file */
	int64_t iterations;	/* jump: iterations of a loop, of which only some were executed */
	size_t index;		/* run: number of runs before it */
	bool bounded, endless;	/* jump: not followed to the end of the loop; the loop seems to have no end */
	bool open;		/* run: its number of steps is unknown; if: the condition is */
	bool leaves;		/* if: a branch may jump or quit */
	bool start_unknown;	/* run: its first step is unknown */
};

/* Executions and steps of a run so far. */
struct ts_check_sum {
	int64_t count, steps;
};

/* Lines between a label and a jump back to it. */
struct ts_check_loop {
	struct ts_check_loop *next;
	const char *file;
	int from, to;	    /* lines */
	int64_t iterations; /* iterations executed since it began */
	bool open;	    /* its number of iterations is unknown */
	/* counters of struct ts_check, and cost, at the start of the last iteration */
	int64_t reached, nexts, branches, step;
	struct ts_total_cost cost;
	struct ts_check_sum *run;
	size_t nruns, run_capacity;
};

struct ts_check {
	struct ts_str errors;  /* diagnostics, in order */
	int nerrors;	       /* errors reported */
	int left_out;	       /* messages left out because they may follow from an error */
	int open;	       /* messages left out because they may follow from an unknown value */
	bool weak;	       /* a line has failed on which later ones may depend: may_follow_from_error */
	bool guesses;	       /* the simulation has got numbers in place of unknown ones: the same */
	bool substitute_box;   /* the box stands in for one that could not be created */
	bool creating_box;     /* that box is being created */
	bool cut;	       /* after an error a loop was left: names that it defines may be missing */
	bool unread;	       /* a restart file could not be read: its groups are unknown */
	struct ts_map seen;    /* "file:line:column" of errors, "file:line" of lines executed */
	struct ts_map lost;    /* "fix ID" that a failed line would have defined */
	struct ts_map events;  /* by kind, place and text */
	struct ts_map guessed; /* "file:line" of lines with an unknown value, and the names they define */
	struct ts_check_event *first, **last;
	struct ts_check_loop *loop;
	size_t nruns;		      /* events that are runs */
	int64_t reached;	      /* different lines executed so far */
	int64_t branches;	      /* `if` commands executed so far */
	int64_t nexts;		      /* `next` commands executed so far */
	int64_t iterations_left;      /* iterations left after the last `next`; 0: unknown */
	const char *next_variable[8]; /* the variables of the last `next` */
	int64_t jumps, runs;	      /* executed so far */
	int64_t jumps_after_error;    /* back, followed or not */
	int alternatives;	      /* > 0: another branch has been executed before this one */
	size_t at;		      /* position behind the last jump, in case its label is not found */
	int line;
	struct ts_arena arena;
};

/* Allocates the state of -check and -explain. */
enum ts_status ts_check_new(struct ts_script *script);
void ts_check_free(struct ts_script *script);
/* check.c: records the error of a line. TS_OK: continue with the next line. */
enum ts_status ts_check_recover(struct ts_script *script, const struct ts_line *line, struct ts_words words,
				enum ts_status status);
/* Records the message of sim->error, unless it may follow from other errors, and clears it. */
enum ts_status ts_check_keep_error(struct ts_script *script, const char *remark);
/* The same, but -explain continues only if the error may follow from an unknown value. */
enum ts_status ts_check_defer_error(struct ts_script *script, enum ts_status status);
/* To be called before a line with an unknown value is executed. */
enum ts_status ts_check_mark_guessed(struct ts_script *script, const struct ts_line *line,
				     struct ts_words words);
/* Marks a name as lost: messages that it does not exist are left out. */
enum ts_status ts_check_mark_lost(struct ts_script *script, const char *kind, const char *name);

/* check_trace.c */
enum ts_status ts_check_begin_line(struct ts_script *script, const struct ts_place *row);
enum ts_status ts_check_record_event(struct ts_script *script, enum ts_check_kind kind,
				     const struct ts_place *where, const char *depends_on,
				     struct ts_check_event **out, const char *format, ...)
	__attribute__((format(printf, 6, 7)));
enum ts_status ts_check_record_run(struct ts_script *script, const struct ts_place *where, int64_t steps);
/* A file that would be written or changed. */
enum ts_status ts_check_record_write(struct ts_script *script, const struct ts_place *where, const char *what,
				     const char *path);
/* Records which branch of an `if` was taken: "then", "elif", "else" or "no branch". */
enum ts_status ts_check_record_branch(struct ts_script *script, const struct ts_place *where,
				      const char *which);

/* check_loop.c: records a jump; *follow: whether to execute it. */
enum ts_status ts_check_jump(struct ts_script *script, const struct ts_place *where, const char *file,
			     const char *label, bool *follow);
/* To be called when the jump at the end of a loop is skipped: the loop has ended. */
void ts_check_leave_loop(struct ts_script *script, const struct ts_place *where);
/* To be called after `next` has advanced these variables. */
void ts_check_record_next(struct ts_script *script, struct ts_words names);
/* The loop that a jump from here to the label closes; *out NULL: the jump goes forward, or into another
 * file. */
enum ts_status ts_check_loop_of(struct ts_script *script, const struct ts_place *where, const char *file,
				const char *label, struct ts_check_loop **out);
/* Marks the number of iterations of a loop as unknown. */
void ts_check_open_loop(struct ts_script *script, struct ts_check_loop *loop);

/* check_branch.c: executes all branches of an `if` from the k-th word on, since its condition is unknown. */
enum ts_status ts_check_run_all_branches(struct ts_script *script, struct ts_words words, size_t k,
					 const struct ts_place *where);

/* check_unreached.c: parses a command of a branch not taken, a line never reached, or a command that will
 * be executed later. `remark` is appended to the message of an error. */
enum ts_status ts_check_unreached(struct ts_script *script, const struct ts_line *line, const char *remark);
/* Parses all commands of an `if`. */
enum ts_status ts_check_unreached_commands(struct ts_script *script, struct ts_words words);

#endif
