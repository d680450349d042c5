/* Several ranks between two runs of a script.
 *
 * After its last step a run leaves a look at all particles, for formulas and inits of the next one, while each rank keeps
 * the lists of its own particles: a run that follows at once makes no lists of all contacts. All ranks get these when a
 * command, or a formula, may read them. Only a script that is the whole program pauses so, as nothing else reads the
 * simulation then. */
#ifndef TS_CORE_RANKS_PAUSE_H
#define TS_CORE_RANKS_PAUSE_H

#include "core/plan.h"

/* After a run that has left a look: keeps its plan, which is empty then. */
enum ts_status ts_ranks_pause(struct tsim *sim, struct ts_plan *plan);
/* The next run begins, or the simulation ends. */
void ts_ranks_end_pause(struct tsim *sim);
/* All ranks get all particles and lists, if the last run has left a look only. */
enum ts_status ts_ranks_unite(struct tsim *sim);

#endif
