/* The plan of a run: for each stage the list of functions to call. The one definition of a step. */
#ifndef TS_CORE_PLAN_H
#define TS_CORE_PLAN_H

#include "core/sim.h"

struct ts_action {
	ts_hook_fn *hook;
	struct ts_instance *self;
	uint64_t site; /* key of random numbers: struct ts_draws in core/sim.h */
	bool watches;  /* the hook is a `watch` slot, called between the hooks of other styles */
	bool defers;   /* the hook may leave loops deferred: core/deferred_loops.h */
	bool late;     /* one of the late hooks of struct ts_style */
};

struct ts_plan {
	struct ts_action *actions[TS_NSTAGE];
	size_t n[TS_NSTAGE], capacity[TS_NSTAGE];
	int64_t rebuilds; /* steps that rebuilt the contact list */
	int64_t faults;	  /* sim->reading.faults when the plan was begun */
	struct ts_stopwatch {
		uint64_t spent[TS_NSTAGE]; /* time in each stage of this run, ticks of ts_ticks() */
		uint64_t last;		   /* ticks at the last reading */
		uint64_t first;		   /* ticks when the run began */
		double begin;		   /* ts_clock() then, s */
	} watch;
};

/* Calls init of every live instance, then lists the hooks of each stage. */
enum ts_status ts_plan_compile(struct ts_plan *plan, struct tsim *sim);
enum ts_status ts_plan_stages(struct ts_plan *plan, struct tsim *sim, enum ts_stage first,
			      enum ts_stage last);
enum ts_status ts_plan_stage(struct ts_plan *plan, struct tsim *sim, enum ts_stage stage);
/* The same as ts_plan_stages, but loops may still be deferred when it returns. */
enum ts_status ts_plan_stages_deferring(struct ts_plan *plan, struct tsim *sim, enum ts_stage first,
					enum ts_stage last);
void ts_plan_release(struct ts_plan *plan);
/* Wall time spent in the stage in this run, s. */
double ts_plan_seconds(const struct ts_plan *plan, enum ts_stage stage);
/* Parts of a step, each of several stages, with the names of LAMMPS: Move, Neigh, Comm, Force, Fixes, Outpt. */
enum { TS_PLAN_PARTS = 6 };
const char *ts_plan_part_name(int part);
/* Wall time spent in the part in this run, s. */
double ts_plan_part_seconds(const struct ts_plan *plan, int part);

/* Steps until sim->clock.last_step or a request to stop. `setup`: first rebuild the contact list and
 * compute forces, unless nothing that forces depend on has changed since the last step. With
 * sim->reading.explain nothing is stepped or written: the plan is printed. */
enum ts_status ts_plan_run(struct ts_plan *plan, struct tsim *sim, bool setup);
/* Its parts, for runs in pieces: set-up and first output; the steps up to clock.last_step; the end. */
enum ts_status ts_plan_start(struct ts_plan *plan, struct tsim *sim, bool setup);
enum ts_status ts_plan_steps(struct ts_plan *plan, struct tsim *sim);
enum ts_status ts_plan_finish(struct ts_plan *plan, struct tsim *sim);
/* The one definition of a step. Loops may still be deferred when it returns: call ts_deferred_loops_run()
 * before reading particles. */
enum ts_status ts_plan_step(struct ts_plan *plan, struct tsim *sim);
/* The set-up of a run: lists, checks, and forces where they are not known (plan_set_up.c). */
enum ts_status ts_plan_set_up(struct ts_plan *plan, struct tsim *sim);
/* Whether all that forces depend on is as it was at the end of the last run: a run can do without a set-up. All ranks call it. */
enum ts_status ts_plan_is_unchanged(struct tsim *sim, bool *unchanged);
/* Before the first step: computes forces if `anew`, then the stage SETUP. */
enum ts_status ts_plan_first_forces(struct ts_plan *plan, struct tsim *sim, bool anew);
/* With several ranks, inside of a run: each gets all particles and their lists, not only a look at the particles. */
enum ts_status ts_plan_have_all(struct ts_plan *plan, struct tsim *sim);
/* TS_STOPPED if a signal handler or the outside program has requested it. */
enum ts_status ts_plan_stopped(struct tsim *sim);

#endif
