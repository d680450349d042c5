/* Settings that can be tried with a scene. */
#ifndef TS_ADVISE_CANDIDATES_H
#define TS_ADVISE_CANDIDATES_H

#include "advise/trial.h"

/* Adds a trial for each setting that applies to the scene. */
void ts_candidates_list(struct tsim *sim, struct ts_trial_results *results);
/* Changes the simulation, which is a copy, to the setting of the trial. */
enum ts_status ts_candidates_apply(struct tsim *sim, const struct ts_trial_results *results,
				   const struct ts_trial *trial);

#endif
