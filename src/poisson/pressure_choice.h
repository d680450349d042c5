/* Choice of the pressure solver: the style of the script, or the default for a problem. */
#ifndef TS_POISSON_PRESSURE_CHOICE_H
#define TS_POISSON_PRESSURE_CHOICE_H

#include "poisson/poisson.h"

/* The live pressure style, or the default style for this problem, which is made at the first call (command
 * pressure_style documents the rules). */
enum ts_status ts_pressure_choose(struct tsim *sim, const struct ts_poisson *problem,
				  const struct ts_place *where, struct ts_instance **out);

/* Adds a line to the plan: the solver, the reason, and the estimated time of a solve. `weights`: faces
 * have weights. */
struct ts_plan_report;
void ts_pressure_explain(const struct tsim *sim, const struct ts_poisson *problem, bool weights,
			 struct ts_plan_report *report);

#endif
