/* Springs and dashpots between a particle and the ground, which fixes add (slot `ground`): their sums, and their limit of the
 * time step. */
#ifndef TS_LIMITS_GROUND_H
#define TS_LIMITS_GROUND_H

#include "core/sim.h"

/* Sets *sum to that of all fixes. Returns the number of fixes that have added a spring or dashpot; *last: the last one of them. */
int ts_ground_of(const struct tsim *sim, size_t i, struct ts_ground_springs *sum,
		 const struct ts_instance **last);
/* The number of fixes with the slot. *last: the last one of them; NULL: there is none. */
int ts_ground_fixes(const struct tsim *sim, const struct ts_instance **last);
/* Reports the largest stable step of a particle alone with all its springs and dashpots to the ground, unless it is that of
 * one fix which reports it in its slot `plan`: a limit of stability, or advice if one of them is an estimate. */
enum ts_status ts_ground_report(struct ts_plan_report *report, struct tsim *sim);

#endif
