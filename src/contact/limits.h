/* Limits of the time step of single contacts: reported in the plan of a run by pair styles and walls, and
 * checked by fix check/timestep/gran. */
#ifndef TS_CONTACT_LIMITS_H
#define TS_CONTACT_LIMITS_H

#include "core/report.h"
#include "law/granular_limit.h"
#include "particle/particles.h"

/* The two lightest mobile particles of a type; immobile ones enter with 1/m = 0. */
struct ts_lightest {
	/* 1/mass: -1: there is no such particle, 0: it is immobile; radius: length */
	double inverse_mass[2], radius[2];
};
/* An array by type, 0 .. ntypes, of the particles of the group; to be freed by ts_free. NULL: out of memory.
 */
struct ts_lightest *ts_lightest(const struct tsim *sim, int group);

/* Reports the largest stable steps of a contact: of the normal motion and, as advice, of slip. `overlap`: the
 * largest present one, length, for laws whose stiffness grows with it; `speed`: of collisions to be expected.
 * `what` names the contact in the message. */
struct ts_contact_case {
	const struct ts_granular_model *model;
	const struct ts_granular_pair *law;
	double r_eff, m_eff, overlap, speed;
};
enum ts_status ts_contact_report_limits(struct ts_plan_report *report, const struct tsim *sim,
					const struct ts_place *where, const struct ts_contact_case *c,
					const char *what);

/* Rayleigh time of the smallest sphere and duration of the shortest Hertzian collision in the group; infinite
 * where there is none. `legacy`: as LIGGGHTS computes it, each sphere colliding with an equal one, and m
 * instead of m*. */
struct ts_granular_times {
	double rayleigh, hertz;
};
enum ts_status ts_granular_times(struct tsim *sim, int group, double speed, bool legacy, const char *who,
				 const struct ts_place *where, struct ts_granular_times *out);

#endif
