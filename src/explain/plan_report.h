/* Report of a run before it starts: limits of the time step, memory, omitted parts, cost. */
#ifndef TS_EXPLAIN_PLAN_REPORT_H
#define TS_EXPLAIN_PLAN_REPORT_H

#include "core/plan.h"

/* Collects limits and report lines of all instances, checks the time step against the limits (error or
 * warning), and prints the report if sim->reading.explain. The slot `judge` of struct ts_tables. */
enum ts_status ts_plan_judge(struct ts_plan *plan, struct tsim *sim, int64_t steps);
/* While the particles are divided among ranks: sets review.found if that may have anything to say of those of this rank. */
enum ts_status ts_plan_judge_own(struct tsim *sim);

#endif
