/* `tsim -sweep` and `tsim -calibrate`: many runs of scripts as processes of their own, with other values of their
 * variables, and the table of what they print in lines RESULT and STUDY. */
#ifndef TS_STUDY_STUDY_H
#define TS_STUDY_STUDY_H

#include "core/sim.h"

/* The words of the command line. Each word may have several parts `NAME=...`, separated by blanks. */
struct ts_study_input {
	struct ts_words scripts;
	struct ts_words sweep, calibrate, vary, replicate; /* arguments of the options of these names */
	struct ts_words vars;				   /* -var NAME VALUE ... */
	struct ts_words own;				   /* further options for each run */
	const char *called;				   /* argv[0] */
	const char *results;				   /* folder; NULL: "results" */
	double tolerance;				   /* NAN: default */
	int jobs; /* number of runs side by side; 0: as many as there are processors for their threads */
	bool no_log;
};

/* Return the exit status: 0; 1 after an error or if runs have failed; 2 for wrong arguments; 3 if a target is not
 * reached. After an error sim->error is set; TS_STOPPED: interrupted, what has ended is in the table. */
int ts_study_sweep(struct tsim *sim, const struct ts_study_input *input);
int ts_study_calibrate(struct tsim *sim, const struct ts_study_input *input);

/* Appends the help on the words of both, for tsim -help. */
void ts_study_help(struct ts_str *out);

#endif
