/* The program around the library: its command line, and the pages that it prints. Functions return an exit
 * status; only main.c ends the program. */
#ifndef TS_PROGRAM_PROGRAM_H
#define TS_PROGRAM_PROGRAM_H

#include <stdio.h>

#include "core/sim.h"

enum { TS_EXIT_USAGE = 2, TS_MOST_VALUES = 256 };

struct ts_word_list {
	struct ts_word word[2 * TS_MOST_VALUES];
	size_t n;
};

/* What the command line says. */
struct ts_setup {
	const char *input, *log, *screen, *doc, *grammar;
	bool help, version, log_given, check, explain, advised, programs, sandboxed;
	const char *help_kind, *help_style;
	FILE *screen_file; /* of -screen, to be closed */
	/* the last two: for the programs that it runs */
	struct ts_word_list crosscheck, advise, sandbox, variables, own;
};

/* Reads the options into the setup and, those that are settings of it, into the simulation. */
int ts_program_options(struct tsim *sim, struct ts_setup *setup, int argc, char **argv);
/* A line for each option. */
void ts_program_list_options(void);
/* To standard error, with a hint. `format` has two %s. */
int ts_program_usage_error(const char *format, const char *what, const char *more);

/* -sandbox: closes the door for good; what is kept, and by whom, is said in the text. */
int ts_program_sandbox(struct tsim *sim, const struct ts_setup *setup, struct ts_str *said);
void ts_program_sandbox_help(struct ts_str *out);

/* Prints the text and releases it. */
int ts_program_print(struct ts_str *text);
/* -help, -grammar EDITOR, -doc DIRECTORY. */
int ts_program_help(const struct ts_setup *setup);
int ts_program_grammar(const char *editor);
int ts_program_manual(const char *directory);

#endif
