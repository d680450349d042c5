/* What a run will cost, for -explain. */
#ifndef TS_CORE_PRICE_H
#define TS_CORE_PRICE_H

#include "core/plan.h"

struct ts_price {
	double seconds; /* a step; NaN: not known */
	int64_t steps;	/* that were tried; 0: the value is that of an earlier run */
};

/* Tries some steps of the run that is about to start, from its first forces to the end of integration,
 * without outputs, in a copy of the process: whatever it does leaves no trace. */
enum ts_status ts_price_steps(struct ts_plan *plan, struct tsim *sim, struct ts_price *out);

/* "0.52 s", "3.1 min", "5.2 h", "12 days" */
void ts_price_time(double seconds, struct ts_str *out);
/* "520 bytes", "3.1 MB" */
void ts_price_bytes(double bytes, struct ts_str *out);

#endif
