/* Evaluation of the trials: changes of the columns, advice, the report. */
#ifndef TS_ADVISE_VERDICT_H
#define TS_ADVISE_VERDICT_H

#include "advise/trial.h"

/* Whether trial k is cheaper than the present settings, but by less than the scatter of the times. */
bool ts_verdict_open(struct ts_trial_results *results, int k);
/* Appends a trial with all settings that are advised; false if fewer than two are. */
bool ts_verdict_combine(struct ts_trial_results *results, double tolerance);
/* Appends the report to `out`. `tolerance`: largest change of a column that is accepted, in units of its
 * range. */
void ts_verdict_print(struct ts_trial_results *results, double tolerance, struct ts_str *out);

#endif
