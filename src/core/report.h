/* What styles report of a run before it starts, and of limits while it goes on: lines of the plan, limits
 * of the time step, outputs, what is left out. explain/plan_report.c prints it. */
#ifndef TS_CORE_REPORT_H
#define TS_CORE_REPORT_H

#include "core/sim.h"

/* What a style may add to the report of -explain and to the checks before a run. */
struct ts_limit {
	double dt;	/* the largest stable step */
	bool fatal;	/* beyond it the run is refused; else only warned */
	bool watched;	/* who reported it stops the run itself, at the very step */
	uint64_t cause; /* the same for the same sort of limit of the same line */
	char text[160]; /* "contact of types 1-1: 2/omega0, k* = ..., m* = ..." */
	struct ts_place where;
};
/* A file, or a series of them, that the run writes. */
struct ts_output {
	char name[80];
	int64_t frames;
	double bytes; /* of one frame */
};
/* What the results do not depend on and is not done. */
struct ts_left_out {
	char name[24], why[120];
	unsigned part; /* the bit of enum ts_full that does it nevertheless; 0: none can */
	double bytes;  /* memory that it would take; 0: none, or not known */
	double share;  /* of the time of a step that it would add; NaN: not known */
};
struct ts_plan_report {
	struct ts_limit *limit;
	size_t nlimits, limit_capacity;
	bool limits_only;    /* while running: nothing but limits is asked for */
	bool advice;	     /* limits that are advice are wanted, too */
	double enough;	     /* limits that are surely larger need not be exact; infinite: all must */
	struct ts_str lines; /* "  particles    3100 ..." */
	struct ts_left_out *left_out;
	size_t nleft_out, left_out_capacity;
	double bytes; /* memory */
	struct ts_output *output;
	size_t noutputs, output_capacity;
};
enum ts_status ts_report_limit(struct ts_plan_report *report, double dt, bool fatal,
			       const struct ts_place *where, const char *format, ...)
	__attribute__((format(printf, 5, 6)));
/* Says so of the limits reported since there were n. */
void ts_report_watched(struct ts_plan_report *report, size_t n);
/* How many multiples of `every` lie in (first, last] of the run. */
int64_t ts_report_count(const struct tsim *sim, int64_t every);
/* A file that the run writes in `frames` pieces of so many bytes each, as far as can be told. */
enum ts_status ts_report_output(struct ts_plan_report *report, const char *name, int64_t frames,
				double bytes);
void ts_report_line(struct ts_plan_report *report, const char *name, const char *format, ...)
	__attribute__((format(printf, 3, 4)));
/* Each name has its proof in tests/core/omissions.sh: the same results with it. */
void ts_report_left_out(struct ts_plan_report *report, const char *name, unsigned part, double bytes,
			const char *format, ...) __attribute__((format(printf, 5, 6)));
void ts_report_release(struct ts_plan_report *report);
/* Asks every live instance, but for outputs if only limits are wanted. */
enum ts_status ts_report_collect(struct ts_plan_report *report, struct tsim *sim);
/* The smallest limit of this sort; NULL: there is none. */
const struct ts_limit *ts_report_binding(const struct ts_plan_report *report, bool fatal);

#endif
