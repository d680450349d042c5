/* A study: its scripts, its variables, the table of its runs; and runs side by side, each a process of its own. */
#ifndef TS_STUDY_STUDY_BATCH_H
#define TS_STUDY_STUDY_BATCH_H

#include "base/process.h"
#include "study/study.h"
#include "study/study_runs.h"
#include "study/study_script.h"
#include "study/study_words.h"

enum { TS_STUDY_MOST_SCRIPTS = 8, TS_STUDY_USAGE = 2, TS_STUDY_MISSED = 3 };

struct ts_study {
	struct tsim *sim;
	const struct ts_study_input *in;
	const char *option; /* for messages: "-sweep" or "-calibrate" */
	struct ts_study_words words;
	struct ts_study_script script[TS_STUDY_MOST_SCRIPTS];
	size_t scripts;
	bool *uses;			      /* [scripts * variables] */
	bool sets_out[TS_STUDY_MOST_SCRIPTS]; /* the script is given a folder `out` for each run */
	struct ts_study_runs runs;
	struct ts_arena arena;
	const char *folder, *table, *program;
	int64_t last;	/* number of the last run */
	size_t started; /* number of runs of this process */
	bool misused;	/* the error is one of the command line */
	FILE *lock;	/* of the folder */
};

/* A run that is wanted. */
struct ts_study_task {
	size_t script;
	const char **value; /* [variables] */
	size_t group;	    /* tasks of a group are averaged */
	size_t run;	    /* afterwards: its row in the table; SIZE_MAX: none */
};

/* Opens the study once its words are parsed: reads the scripts, tests them with -check and the values of `first`, reads
 * the table. */
enum ts_status ts_study_open(struct ts_study *s, const char *const *first);
/* Runs the tasks that are not in the table yet. Runs that fail are no error. TS_STOPPED: interrupted. */
enum ts_status ts_study_run_all(struct ts_study *s, struct ts_study_task *task, size_t n);
void ts_study_release(struct ts_study *s);

/* Appends "NAME=VALUE ..." of the variables that are not fixed. */
void ts_study_name_values(const struct ts_study *s, const char *const *value, struct ts_str *out);
/* Values of variables that are tied, from those of the others. */
enum ts_status ts_study_tie(struct ts_study *s, const char **value);
/* An error of the command line; returns the status. */
#define ts_study_misuse(s, ...) ((s)->misused = true, ts_fail(&(s)->sim->error, TS_SYNTAX, NULL, __VA_ARGS__))
/* Releases the study and returns the exit status: `verdict` unless there is an error. */
int ts_study_end(struct ts_study *s, enum ts_status status, int verdict);
/* Replaces a file of the folder of results by the text. */
enum ts_status ts_study_write(struct ts_study *s, const char *name, const struct ts_str *text);

#endif
