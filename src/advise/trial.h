/* One trial, and the board on which the processes of -advise write what they found: memory that they share,
 * so without pointers. */
#ifndef TS_ADVISE_TRIAL_H
#define TS_ADVISE_TRIAL_H

#include <stdbool.h>
#include <stdint.h>

#include "core/sim.h"

enum {
	TS_TRIAL_MOST = 32,
	TS_TRIAL_COLUMNS = 40,
	TS_TRIAL_LOOKS = 8, /* times at which the columns are read */
	TS_TRIAL_TEXT = 96,
};

/* Of each subject the best setting is advised, if it is better than what the scene has. */
enum ts_subject {
	TS_SUBJECT_PRESENT, /* as the script has it */
	TS_SUBJECT_TWIN,    /* the same, each particle moved by round-off: how far the columns can be told */
	TS_SUBJECT_STEP,
	TS_SUBJECT_SKIN,
	TS_SUBJECT_THREADS,
	TS_SUBJECT_CHOICE,   /* an argument of the pair or flow style */
	TS_SUBJECT_PRESSURE, /* who solves for the pressure */
	TS_SUBJECT_TOGETHER, /* all that is advised */
	TS_NSUBJECT
};

struct ts_trial {
	bool law;	     /* another law of contacts */
	int subject, choice; /* the latter: which row of the table of choices */
	char label[TS_TRIAL_TEXT], value[TS_TRIAL_TEXT];
	double dt, skin; /* 0: as it is */
	int threads;	 /* 0: as it is */

	/* what came out */
	bool done;
	char trouble[3 * TS_TRIAL_TEXT]; /* why it is not */
	int64_t steps;
	double seconds, longest; /* the least and the longest time of its repeats */
	double contacts;	 /* how many touched, at most, when it was looked at */
	int looks;
	double column[TS_TRIAL_LOOKS + 1][TS_TRIAL_COLUMNS]; /* the first: at the start */

	/* what it means */
	bool undecided;	     /* it seems cheaper, but by no more than times differ anyway */
	bool idle;	     /* another law of contacts, and nothing touched */
	bool advised, front; /* front: nothing is both cheaper and closer to the finest */
	double change[TS_TRIAL_COLUMNS], worst; /* against the finest, in units of the column's scale */
	int worst_column;
};

struct ts_board {
	/* the way there: what the script runs */
	int64_t runs, costliest; /* number of run commands; of which the most work is done, from 0 */
	double work;		 /* of that one: steps times particles */
	bool cut;		 /* the time was over before the script was */
	char trouble[4096];	 /* the error that ended the script */

	/* where the trials start */
	bool arrived;
	char place[2 * TS_TRIAL_TEXT];
	int64_t step, left, whole; /* of the run there: steps still to do, and of all */
	int64_t particles;
	double time, dt, skin, limit; /* limit of the step; INFINITY: none */
	int threads;
	double step_seconds; /* of one step, before the trials */

	/* the trials */
	int64_t steps;			  /* of the present dt */
	int repeats;			  /* the least time counts */
	char counters[2 * TS_TRIAL_TEXT]; /* fixes that act every so many steps */
	int columns;
	char title[TS_TRIAL_COLUMNS][16];
	/* by the steps, so with another step it is another thing: not judged */
	bool counts[TS_TRIAL_COLUMNS];
	int n;
	struct ts_trial trial[TS_TRIAL_MOST];
};

/* Steps for some tenths of a second, in a copy: fills in step_seconds, limit, skin and the titles. */
void ts_trial_probe(struct tsim *sim, struct ts_board *board, double seconds);
/* Runs the k-th trial in a copy; gives up after so many seconds. */
void ts_trial_run(struct tsim *sim, struct ts_board *board, int k, double seconds);

/* Once more; the least and the longest time are kept. */
void ts_trial_repeat(struct tsim *sim, struct ts_board *board, int k, double seconds);

#endif
