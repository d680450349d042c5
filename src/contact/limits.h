/* How long a step contacts bear: what the plan of a run says of pairs and walls, and fix
 * check/timestep/gran. */
#ifndef TS_CONTACT_LIMITS_H
#define TS_CONTACT_LIMITS_H

#include "core/report.h"
#include "law/granular_limit.h"
#include "particle/particles.h"

/* The two lightest particles of a type that can move, and whether there are held ones. */
struct ts_lightest {
	double inverse_mass[2], radius[2]; /* -1: there is none; 0: held */
};
/* By type, 0 .. ntypes; of the group. NULL: out of memory. ts_free when done. */
struct ts_lightest *ts_lightest(const struct tsim *sim, int group);

/* Reports the largest steps of the motion along the normal and of slip. `overlap`: the deepest that there is
 * now, for laws that stiffen, `speed`: of collisions to expect. */
struct ts_contact_case {
	const struct ts_granular_model *model;
	const struct ts_granular_pair *law;
	double r_eff, m_eff, overlap, speed;
};
enum ts_status ts_contact_report_limits(struct ts_plan_report *report, const struct tsim *sim,
					const struct ts_place *where, const struct ts_contact_case *c,
					const char *what);

/* Rayleigh's time of the smallest sphere and the duration of the shortest Hertz collision in the group;
 * infinite where there is none. `legacy`: as LIGGGHTS takes it, each sphere with one like itself, and m
 * for m*. */
struct ts_granular_times {
	double rayleigh, hertz;
};
enum ts_status ts_granular_times(struct tsim *sim, int group, double speed, bool legacy, const char *who,
				 const struct ts_place *where, struct ts_granular_times *out);

#endif
