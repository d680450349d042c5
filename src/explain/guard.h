/* Checks of the time step during a run: the stability limits that the plan evaluates at the start of a run
 * are evaluated again at intervals, because stiffnesses, masses and velocities change.
 *
 * The steps of these checks depend on the previous checks only, not on where runs begin and end. The state
 * is written to restart files, so that a run cut in two prints the same warnings as the whole run. */
#ifndef TS_EXPLAIN_GUARD_H
#define TS_EXPLAIN_GUARD_H

#include "core/report.h"

enum { TS_TOLD = 48 }; /* largest number of causes; there are no more warnings after that */

/* Causes of warnings printed so far; the two lowest bits are the level of the warning. */
struct ts_told {
	int64_t cause[TS_TOLD];
	int32_t n;
};

struct ts_guard {
	double dt;	      /* time step for which the fields below hold */
	double fraction;      /* dt / smallest stability limit at the last check */
	int64_t next;	      /* step of the next check; 0: no check so far */
	int64_t interval;     /* steps from that check to the following one */
	int64_t until;	      /* beyond a limit: checks at every step until this one */
	int32_t seen;	      /* number of these checks that were beyond the limit */
	struct ts_told told;  /* warnings of these checks; written to restart files */
	struct ts_told heard; /* warnings at the starts of runs; not written */
};

/* At the start of a run: a time step beyond a stability limit is an error; one near a limit, or beyond an
 * advised value, gives a warning, once for each cause. */
enum ts_status ts_guard_judge(struct tsim *sim, const struct ts_plan_report *report);
/* Whether that, of the limits of the particles of this rank, may say or refuse anything. */
bool ts_guard_has_doubts(struct tsim *sim, const struct ts_plan_report *report);

/* Limits (time) above this one cause no warning. */
double ts_guard_enough(const struct tsim *sim);

extern const struct ts_system_style ts_guard_system;

#endif
