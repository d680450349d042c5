/* The command line of the program, and the pages that it prints. Functions return an exit status; only main.c
 * ends the program. */
#ifndef TS_PROGRAM_PROGRAM_H
#define TS_PROGRAM_PROGRAM_H

#include <stdio.h>

#include "core/sim.h"

enum { TS_EXIT_USAGE = 2, TS_MOST_VALUES = 256 };

struct ts_word_list {
	struct ts_word word[2 * TS_MOST_VALUES];
	size_t n;
};

/* Words of options that belong to -plot; NULL: not given. */
struct ts_plot_words {
	const char *out, *xrange, *yrange, *part, *by, *title, *xlabel, *ylabel, *size, *right_range,
		*right_label;
	bool panels;
};

/* The options of the command line. */
struct ts_setup {
	const char *input, *log, *screen, *doc, *grammar, *results;
	bool help, version, log_given, check, explain, advised, programs, sandboxed;
	char *const *help_words; /* after -help */
	int help_count;
	FILE *screen_file; /* of -screen; the caller closes it */
	/* arguments of options; variables and own: -var, -threads and -shell, for programs that -crosscheck
	 * and -advise run */
	struct ts_word_list crosscheck, advise, sandbox, variables, own;
	/* -in, and arguments of -sweep, -calibrate, -vary and -replicate */
	struct ts_word_list inputs, sweep, calibrate, vary, replicate;
	struct ts_word_list report; /* FILE and words of `report file` */
	double tolerance;	    /* 0: not given */
	int64_t jobs;		    /* 0: not given */
	bool studied;		    /* -sweep or -calibrate */
	/* "-plot" FILE COLUMN ..., "-right" COLUMN ..., "-x" COLUMN, "-style" STYLE, in the order of the command line */
	struct ts_word_list plot;
	struct ts_word_list marks;
	bool plots, plot_words; /* -plot is given; options that belong to it are */
	struct ts_plot_words plotted;
};

/* Reads the options into the setup and, if they are settings of the simulation, into sim. */
int ts_program_options(struct tsim *sim, struct ts_setup *setup, int argc, char **argv);
struct ts_program_option {
	const char *name, *values, *help;
	int least;	   /* smallest number of values */
	const char *alias; /* short name, as in LAMMPS; may be NULL */
};
/* Option k, from 0; NULL at the end. */
const struct ts_program_option *ts_program_option(size_t k);
/* Prints a line for each option. */
void ts_program_list_options(void);
/* Prints an error and a hint to standard error; returns TS_EXIT_USAGE. `format` has two %s. */
int ts_program_usage_error(const char *format, const char *what, const char *more);

/* -sandbox: restricts access to files irrevocably; appends to `said` what is restricted, and by which
 * means. */
int ts_program_sandbox(struct tsim *sim, const struct ts_setup *setup, struct ts_str *said);
void ts_program_sandbox_help(struct ts_str *out);

/* -sweep and -calibrate; returns the exit status. `called`: argv[0]. */
int ts_program_study(struct tsim *sim, struct ts_setup *setup, const char *called);

/* -plot; returns the exit status. The message of an error is in sim->error. */
int ts_program_plot(struct tsim *sim, const struct ts_setup *setup);
/* -report: refuses options that do not go with it; begins the report, after the options have been read; ends it with the
 * script, and returns the exit status, which a page that cannot be written changes. */
int ts_program_check_report(const struct ts_setup *setup);
int ts_program_report(struct tsim *sim, const struct ts_setup *setup, char **argv);
int ts_program_report_end(struct tsim *sim, int quit);

/* Prints the text and releases it. */
int ts_program_print(struct ts_str *text);
/* -help, -grammar EDITOR, -doc DIRECTORY. */
int ts_program_help(const struct ts_setup *setup);
int ts_program_grammar(const char *editor);
void ts_program_bash(struct ts_str *out);
/* -version */
int ts_program_version(void);
int ts_program_manual(const char *directory);

#endif
