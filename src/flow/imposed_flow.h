/* Flow styles whose velocity is given. */
#ifndef TS_FLOW_IMPOSED_FLOW_H
#define TS_FLOW_IMPOSED_FLOW_H

#include "core/report.h"

/* Tells the plan that no solver is needed. */
void ts_imposed_flow_report(struct ts_plan_report *report, const struct tsim *sim);

#endif
