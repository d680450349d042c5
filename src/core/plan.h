/* The plan of a run: for each stage the list of functions to call. The one definition of a step. */
#ifndef TS_CORE_PLAN_H
#define TS_CORE_PLAN_H

#include "core/sim.h"

struct ts_action {
	ts_hook_fn *hook;
	struct ts_instance *self;
	uint64_t site; /* key of random numbers: struct ts_draws in core/sim.h */
	bool watches;  /* a `watch` slot: called around the actions of others */
	bool defers;   /* may defer its loops: core/deferred_loops.h */
	bool late;     /* one of the late hooks of struct ts_style */
};

struct ts_plan {
	struct ts_action *actions[TS_NSTAGE];
	size_t n[TS_NSTAGE], capacity[TS_NSTAGE];
	int64_t rebuilds; /* steps that found new rows */
	struct ts_stopwatch {
		uint64_t spent[TS_NSTAGE]; /* ticks in each stage of this run */
		uint64_t last;		   /* ticks at the last reading */
		uint64_t first;		   /* when the run began, by ticks and in seconds */
		double begin;
	} watch;
};

/* Calls init of every live instance, then lists per stage those that have something to do. */
enum ts_status ts_plan_compile(struct ts_plan *plan, struct tsim *sim);
enum ts_status ts_plan_stages(struct ts_plan *plan, struct tsim *sim, enum ts_stage first,
			      enum ts_stage last);
enum ts_status ts_plan_stage(struct ts_plan *plan, struct tsim *sim, enum ts_stage stage);
void ts_plan_release(struct ts_plan *plan);
/* Wall time spent in the stage in this run. */
double ts_plan_seconds(const struct ts_plan *plan, enum ts_stage stage);

/* Steps until sim->clock.last_step or a stop. `setup`: rebuild rows and, unless nothing that forces
 * depend on has changed since the last step, compute forces anew. With sim->reading.explain nothing is
 * stepped or written: the plan is printed. */
enum ts_status ts_plan_run(struct ts_plan *plan, struct tsim *sim, bool setup);
/* Its parts, for runs in pieces: until the first output; the steps up to clock.last_step; the end. */
enum ts_status ts_plan_start(struct ts_plan *plan, struct tsim *sim, bool setup);
enum ts_status ts_plan_steps(struct ts_plan *plan, struct tsim *sim);
enum ts_status ts_plan_finish(struct ts_plan *plan, struct tsim *sim);
/* The one definition of a step. Loops may still be deferred when it returns: call ts_run_deferred_loops()
 * before reading particles. */
enum ts_status ts_plan_step(struct ts_plan *plan, struct tsim *sim);
/* What comes before the first one: forces, if they are to be computed anew, and SETUP. */
enum ts_status ts_plan_first_forces(struct ts_plan *plan, struct tsim *sim, bool anew);
/* TS_STOPPED if someone asked for it. */
enum ts_status ts_plan_stopped(struct tsim *sim);

/* Hash of every setting forces depend on (resolved arguments of pair, bond, flow, fixes; dt; box and
 * particle columns as far as systems archive them). */
enum ts_status ts_sim_fingerprint(struct tsim *sim, uint64_t *out);

#endif
