/* The plan of a run: who acts in which stage, what is modelled and left out, and the limits of the
 * time step. */
#ifndef TS_CORE_PLAN_H
#define TS_CORE_PLAN_H

#include "core/sim.h"

struct ts_action {
	ts_hook_fn *hook;
	struct ts_instance *self;
	uint64_t site; /* for random numbers: ts_draws in core/sim.h */
	bool watches;  /* what others do */
	bool waits;    /* with what it does: see core/sweep.h */
	bool late;     /* one of the late hooks of struct ts_style */
};

struct ts_plan {
	struct ts_action *actions[TS_NSTAGE];
	size_t n[TS_NSTAGE], capacity[TS_NSTAGE];
	int64_t rebuilds; /* steps that found new rows */
	struct ts_stopwatch {
		uint64_t spent[TS_NSTAGE]; /* ticks in each stage of this run */
		uint64_t last;		   /* when it was last looked at */
		uint64_t first;		   /* when the run began, by ticks and in seconds */
		double begin;
	} watch;
};

/* Hash of who acts in which stage; never 0. */
uint64_t ts_plan_site(const struct ts_instance *inst, int stage);

/* Calls init of every live instance, then lists per stage those that have something to do. */
enum ts_status ts_plan_compile(struct ts_plan *plan, struct tsim *sim);
enum ts_status ts_plan_stages(struct ts_plan *plan, struct tsim *sim, enum ts_stage first,
			      enum ts_stage last);
enum ts_status ts_plan_stage(struct ts_plan *plan, struct tsim *sim, enum ts_stage stage);
void ts_plan_release(struct ts_plan *plan);
/* Wall time spent in the stage in this run. */
double ts_plan_seconds(const struct ts_plan *plan, enum ts_stage stage);

/* Steps until sim->clock.last_step or a stop. `setup`: rebuild rows and, unless nothing that forces
 * depend on has changed since the last step, compute forces anew. With sim->explain nothing is
 * stepped or written: the plan is printed. */
enum ts_status ts_plan_run(struct ts_plan *plan, struct tsim *sim, bool setup);
/* Its parts, for runs in pieces: until the first output; the steps up to clock.last_step; the end. */
enum ts_status ts_plan_start(struct ts_plan *plan, struct tsim *sim, bool setup);
enum ts_status ts_plan_steps(struct ts_plan *plan, struct tsim *sim);
enum ts_status ts_plan_finish(struct ts_plan *plan, struct tsim *sim);
/* The one definition of a step. Passes over the particles may still wait when it returns: ts_sweep() before anybody
 * looks. */
enum ts_status ts_plan_step(struct ts_plan *plan, struct tsim *sim);
/* What comes before the first one: forces, if they are to be computed anew, and SETUP. */
enum ts_status ts_plan_first_forces(struct ts_plan *plan, struct tsim *sim, bool anew);
/* TS_STOPPED if someone asked for it. */
enum ts_status ts_plan_stopped(struct tsim *sim);

/* What a style may add to the report of -explain and to the checks before a run. */
struct ts_limit {
	double dt;           /* the largest stable step */
	bool fatal;          /* beyond it the run is refused; else only warned */
	bool watched;	     /* who reported it stops the run itself, at the very step */
	uint64_t cause;      /* the same for the same sort of limit of the same line */
	char text[160];      /* "contact of types 1-1: 2/omega0, k* = ..., m* = ..." */
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
	bool limits_only;      /* while running: nothing but limits is asked for */
	bool advice;	       /* limits that are advice are wanted, too */
	double enough;	       /* limits that are surely larger need not be exact; infinite: all must */
	struct ts_str lines;   /* "  particles    3100 ..." */
	struct ts_left_out *left_out;
	size_t nleft_out, left_out_capacity;
	double bytes;          /* memory */
	struct ts_output *output;
	size_t noutputs, output_capacity;
};
enum ts_status ts_report_limit(struct ts_plan_report *report, double dt, bool fatal,
			       const struct ts_place *where, const char *format, ...)
	__attribute__((format(printf, 5, 6)));
/* Says so of the limits reported since there were n. */
void ts_report_watched(struct ts_plan_report *report, size_t n);
/* How many multiples of `every` lie in (first, last] of the run. */
int64_t ts_report_times(const struct tsim *sim, int64_t every);
/* A file that the run writes in `frames` pieces of so many bytes each, as far as can be told. */
enum ts_status ts_report_output(struct ts_plan_report *report, const char *name, int64_t frames,
				double bytes);
void ts_report_line(struct ts_plan_report *report, const char *name, const char *format, ...)
	__attribute__((format(printf, 3, 4)));
/* Each name has its proof in tests/omissions.sh: the same results with it. */
void ts_report_left_out(struct ts_plan_report *report, const char *name, unsigned part, double bytes,
			const char *format, ...) __attribute__((format(printf, 5, 6)));
void ts_report_release(struct ts_plan_report *report);
/* Asks every live instance, but for outputs if only limits are wanted. */
enum ts_status ts_report_collect(struct ts_plan_report *report, struct tsim *sim);
/* The smallest limit of this sort; NULL: there is none. */
const struct ts_limit *ts_report_binding(const struct ts_plan_report *report, bool fatal);

/* Asks every live instance, checks dt against the limits (refusal or warning), and prints the report
 * when sim->explain. */
enum ts_status ts_plan_review(struct ts_plan *plan, struct tsim *sim, int64_t steps);

/* Hash of every setting forces depend on (resolved arguments of pair, bond, flow, fixes; dt; box and
 * particle columns as far as systems archive them). */
enum ts_status ts_sim_fingerprint(struct tsim *sim, uint64_t *out);

#endif
