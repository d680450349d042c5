/* What a run on several ranks has and sends on each, for -explain. The model is that of doc/scaling.md. */
#ifndef TS_EXPLAIN_RANK_REPORT_H
#define TS_EXPLAIN_RANK_REPORT_H

#include "core/report.h"

/* Prints particles, copies, contacts, messages and bytes of the first rank, of the mean and of the largest one of
 * ts_ranks(sim) ranks; their memory, and the time of a step if that of one rank is known: `seconds`, or NaN. */
enum ts_status ts_rank_report(struct tsim *sim, const struct ts_plan_report *report, double seconds);

#endif
