/* Reports of live styles for -explain and for the check of the time step: lines of the plan, limits of the
 * time step, output files, work left out. explain/plan_report.c prints them. */
#ifndef TS_CORE_REPORT_H
#define TS_CORE_REPORT_H

#include "core/sim.h"

struct ts_limit {
	double dt;	/* the largest stable time step [time]; 0: there is none */
	bool fatal;	/* a larger step is refused; else only a warning is given */
	bool watched;	/* the style that reported it checks it itself in each step and stops the run */
	uint64_t cause; /* hash of script line and sort of limit: warnings are given once for each */
	char text[320]; /* "contact of types 1-1: 2/omega0, k* = ..., m* = ..." */
	struct ts_place where;
};
/* A file, or a series of files, that the run writes. */
struct ts_output {
	char name[80];
	int64_t frames;
	double bytes; /* of one frame */
};
/* Work that is left out because results do not depend on it. */
struct ts_left_out {
	char name[24], why[120];
	unsigned part; /* the bit of enum ts_full by which it is done nevertheless; 0: there is none */
	double bytes;  /* memory that it would take, bytes; 0: none, or not known */
	double share;  /* time that it would add, as a fraction of the time of a step; NaN: not known */
};
struct ts_rank_layout;
struct ts_world_counts;
struct ts_plan_report {
	struct ts_limit *limit;
	size_t nlimits, limit_capacity;
	bool limits_only; /* during a run: only limits are collected */
	bool advice;	  /* also collect recommended, not only stability limits */
	double enough;	  /* limits above this [time] may be estimates; infinite: all are exact */
	bool undecided;	  /* the particles are divided among ranks, and a limit needs those of other ranks */
	struct ts_str lines; /* "  particles    3100 ..." */
	struct ts_left_out *left_out;
	size_t nleft_out, left_out_capacity;
	double bytes;	   /* memory of the simulation, bytes */
	double whole;	   /* the part of it that does not depend on the particles of a rank */
	double elsewhere;  /* the part of a grid that other ranks have */
	bool divides_grid; /* `whole` is of some planes of the grid of a fluid */
	/* With several ranks: what each of them sends to all others in a step besides copies of particles. */
	struct ts_report_shared {
		int messages;
		double bytes; /* of each of its particles */
	} shared;
	/* What it sends to each rank that has copies of its particles, besides their columns. */
	struct ts_report_copied {
		int messages;
		double bytes; /* of each copy */
	} copied;
	/* What else it sends. `count` adds to sent[r] what rank r sends in so many steps, with so many iterations of a solver.
	 * NULL: nothing. */
	struct ts_report_rehearsal {
		struct ts_instance *self;
		enum ts_status (*count)(struct ts_instance *self, struct tsim *sim,
					const struct ts_rank_layout *layout, int iterations,
					struct ts_world_counts *sent);
		int64_t steps;
		int looks; /* iterations from one look at the residual to the next; 0: no solver iterates */
	} rehearsal;
	struct ts_output *output;
	size_t noutputs, output_capacity;
};
enum ts_status ts_report_limit(struct ts_plan_report *report, double dt, bool fatal,
			       const struct ts_place *where, const char *format, ...)
	__attribute__((format(printf, 5, 6)));
/* Sets `watched` of the limits reported after the first n. */
void ts_report_watched(struct ts_plan_report *report, size_t n);
/* The number of multiples of `every` among the steps of the run. */
int64_t ts_report_count(const struct tsim *sim, int64_t every);
/* A file that the run writes, with the estimated size of each frame in bytes. */
enum ts_status ts_report_output(struct ts_plan_report *report, const char *name, int64_t frames,
				double bytes);
void ts_report_line(struct ts_plan_report *report, const char *name, const char *format, ...)
	__attribute__((format(printf, 3, 4)));
/* tests/core/omissions.sh proves for each name that results are the same with and without it. */
void ts_report_left_out(struct ts_plan_report *report, const char *name, unsigned part, double bytes,
			const char *format, ...) __attribute__((format(printf, 5, 6)));
void ts_report_release(struct ts_plan_report *report);
/* Calls the slot `plan` of every live instance; computes and dumps are left out if only limits are
 * collected. */
enum ts_status ts_report_collect(struct ts_plan_report *report, struct tsim *sim);
/* The smallest fatal, or not fatal, limit; NULL: there is none. */
const struct ts_limit *ts_report_binding(const struct ts_plan_report *report, bool fatal);

#endif
