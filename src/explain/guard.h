/* The guard of the time step: while a run goes on it asks again, now and then, for the limits that the plan
 * asked for at the start, because stiffnesses, masses and velocities change.
 *
 * It looks at steps that depend on what it has seen only, not on where runs begin and end: its state is
 * saved, so that a run cut in two says what the whole run says. */
#ifndef TS_EXPLAIN_GUARD_H
#define TS_EXPLAIN_GUARD_H

#include "core/report.h"

enum { TS_TOLD = 48 }; /* causes that are remembered; there are no more warnings then */

/* Causes that have been spoken of, each with how bad it was in the lowest two bits. */
struct ts_told {
	int64_t cause[TS_TOLD];
	int32_t n;
};

struct ts_guard {
	double dt;	      /* the time step that all below is about */
	double fraction;      /* of the smallest limit of stability, at the last look */
	int64_t next;	      /* step of the next look; 0: there has been none */
	int64_t interval;     /* to the one after it */
	int64_t until;	      /* beyond a limit: looks at every step up to this one */
	int32_t seen;	      /* how often it was beyond since then */
	struct ts_told told;  /* saved */
	struct ts_told heard; /* what starts of runs have said; not saved */
};

/* At the start of a run: refuses a step beyond a limit of stability, warns of one that is near or beyond what
 * is advised, of each cause once. */
enum ts_status ts_guard_judge(struct tsim *sim, const struct ts_plan_report *report);

/* Larger limits need no warning. */
double ts_guard_enough(const struct tsim *sim);

extern const struct ts_system_style ts_guard_system;

#endif
