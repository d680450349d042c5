/* Trials of settings, and their results: memory that the processes of -advise share, hence without
 * pointers. */
#ifndef TS_ADVISE_TRIAL_H
#define TS_ADVISE_TRIAL_H

#include <stdbool.h>
#include <stdint.h>

#include "core/sim.h"

enum {
	TS_TRIAL_MOST = 32,    /* number of trials */
	TS_TRIAL_COLUMNS = 40, /* columns of the thermo output that are compared */
	TS_TRIAL_SAMPLES = 8,  /* number of times at which the columns are evaluated */
	TS_TRIAL_TEXT = 96,    /* length of labels */
};

/* What a trial changes. For each subject the best setting is advised if it is better than the present one. */
enum ts_subject {
	TS_SUBJECT_PRESENT, /* nothing: the settings of the script */
	/* nothing, but each particle is displaced by round-off: shows to how many digits the columns are
	 * reproducible */
	TS_SUBJECT_PERTURBED,
	TS_SUBJECT_STEP,
	TS_SUBJECT_SKIN,
	TS_SUBJECT_THREADS,
	TS_SUBJECT_CHOICE,   /* an argument of the pair or flow style */
	TS_SUBJECT_PRESSURE, /* the pressure solver */
	TS_SUBJECT_TOGETHER, /* all settings that are advised */
	TS_NSUBJECT
};

struct ts_trial {
	/* the setting */
	bool contact_law;    /* changes the contact law */
	int subject, choice; /* enum ts_subject; index in the table of choices (candidates.c) */
	char label[TS_TRIAL_TEXT], value[TS_TRIAL_TEXT];
	double dt, skin; /* 0: unchanged (time units, length units) */
	int threads;	 /* 0: unchanged */

	/* the measurement */
	bool done;
	char failure[3 * TS_TRIAL_TEXT]; /* why it is not done */
	int64_t steps;
	double seconds, longest; /* shortest and longest time of the repetitions (s) */
	double contacts;	 /* largest number of touching contacts at the samples */
	int samples;
	double column[TS_TRIAL_SAMPLES + 1][TS_TRIAL_COLUMNS]; /* values at the samples; [0]: at the start */

	/* the evaluation, verdict.c */
	bool undecided;	  /* cheaper, but by less than the scatter of the measured times */
	bool no_contacts; /* another contact law, but there was no contact */
	bool advised;
	bool pareto; /* no other trial is both cheaper and closer to the reference trial */
	/* largest differences from the reference trial, in units of the scale of the column */
	double change[TS_TRIAL_COLUMNS], worst;
	int worst_column;
};

struct ts_trial_results {
	/* execution of the script up to the start of the trials */
	int64_t runs;	    /* number of run commands so far */
	int64_t costliest;  /* index of the run with the most work, from 0 */
	double work;	    /* work of that run: steps times particles */
	bool out_of_time;   /* stopped before the end of the script since the time was used up */
	char failure[4096]; /* error message that ended the script */

	/* state at the start of the trials */
	bool started;
	char location[2 * TS_TRIAL_TEXT];    /* "FILE:LINE: run of N steps" */
	int64_t step, steps_left, run_steps; /* present step; steps left, and all steps, of the run there */
	int64_t particles;
	double time, dt, skin, limit; /* limit: largest stable time step; INFINITY: none */
	int threads;
	double step_seconds; /* wall time of a step before the trials (s) */

	/* the trials */
	int64_t steps; /* length of a trial, in steps of the present dt */
	int repeats;   /* number of repetitions, of which the shortest time is used */
	char interval_fixes[2 *
			    TS_TRIAL_TEXT]; /* fixes that act at intervals in steps, and their arguments */
	int columns;
	char title[TS_TRIAL_COLUMNS][16];
	/* the value is defined by a number of steps, so that trials of different dt cannot be compared */
	bool step_dependent[TS_TRIAL_COLUMNS];
	int n;
	struct ts_trial trial[TS_TRIAL_MOST];
};

/* Measures some steps in a forked copy, for `seconds`; sets step_seconds, limit, title, interval_fixes. */
void ts_trial_probe(struct tsim *sim, struct ts_trial_results *results, double seconds);
/* Runs trial k, with its repetitions, in forked copies; each is given up after `seconds`. */
void ts_trial_run(struct tsim *sim, struct ts_trial_results *results, int k, double seconds);
/* Repeats trial k; updates its shortest and longest time. */
void ts_trial_repeat(struct tsim *sim, struct ts_trial_results *results, int k, double seconds);

#endif
