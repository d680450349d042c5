/* The progress line of a terminal, and the estimated duration of long runs. */
#ifndef TS_THERMO_PROGRESS_H
#define TS_THERMO_PROGRESS_H

#include "core/sim.h"

/* State of the present run command; zero-initialise. */
struct ts_progress {
	int64_t first;	/* step at which the run command began */
	double began;	/* ts_clock() then, s */
	int64_t look;	/* step at which the clock is read next: steps may be far shorter than a reading */
	double due;	/* ts_clock() of the next line, s */
	bool estimated; /* the duration has been estimated */
	struct ts_progress_mark {
		int64_t step;
		double time; /* ts_clock(), s */
	} last, mark[2];     /* the last reading; the rate is that since mark[0], which is 10 to 20 s ago */
};

/* At the first output of a run, or of the next part of a `run ... every`. */
void ts_progress_begin(struct ts_progress *p, const struct tsim *sim);
/* At each step. Shows the line on a terminal where nothing has been printed for a while, and passes it to the
 * callback of the log; prints once the estimated duration of the run if that is more than a minute. */
void ts_progress_step(struct ts_progress *p, struct tsim *sim);

/* What a line tells; rates are NaN, the end is negative, if they are not known. */
struct ts_progress_facts {
	int64_t first, step, last; /* last < first: not known */
	double steps_per_second;
	size_t particles;
	double left; /* s */
};
/* *out: the line, of at most `width` characters; the least important parts are left out first. */
void ts_progress_line(const struct ts_progress_facts *facts, int width, char *out, size_t size);
/* "45 s", "12 min 5 s", "3 h 20 min", "2 d 3 h" */
void ts_progress_duration(double seconds, char *out, size_t size);

#endif
