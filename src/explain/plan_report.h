/* What a run is going to do, said before it starts: limits of the time step, memory, what is left out,
 * cost. */
#ifndef TS_EXPLAIN_PLAN_REPORT_H
#define TS_EXPLAIN_PLAN_REPORT_H

#include "core/plan.h"

/* Asks every live instance for its limits and lines, checks the time step against the limits (refusal or
 * warning), and prints the report when sim->reading.explain. The slot `judge` of struct ts_tables. */
enum ts_status ts_plan_judge(struct ts_plan *plan, struct tsim *sim, int64_t steps);

#endif
