/* Estimated wall time of a run, for -explain. */
#ifndef TS_EXPLAIN_PRICE_H
#define TS_EXPLAIN_PRICE_H

#include "core/plan.h"

/* Times some steps of the run that is about to start in a copy of the process, which cannot change the
 * simulation and whose output is discarded; then the same with the particles moved together to a dense
 * packing. */
enum ts_status ts_price_steps(struct ts_plan *plan, struct tsim *sim, struct ts_price *out);

/* *out: seconds for a step that includes the omitted parts `part`, bits of enum ts_full; NaN: not known. */
enum ts_status ts_price_full(struct ts_plan *plan, struct tsim *sim, unsigned part, double *out);

/* "0.52 s", "3.1 min", "5.2 h", "12 days" */
void ts_price_time(double seconds, struct ts_str *out);
/* "520 bytes", "3.1 MB" */
void ts_price_bytes(double bytes, struct ts_str *out);

#endif
