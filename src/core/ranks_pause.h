/* Several ranks between two runs of a script.
 *
 * After its last step a run leaves the particles divided, or a look at all of them if its last output or the inits of the
 * next one read them, while each rank keeps the lists of its own particles: a run that follows at once makes no lists of
 * all contacts. All ranks get the columns of all particles when a formula reads them, and all lists when a command, or a
 * formula, may read these. Only a script that is the whole program pauses so, as nothing else reads the simulation then.
 *
 * Commands that make particles before the first run divide them at once (particle/division.h, ts_division_make): the plan
 * of the pause is empty, as behind read_restart, and commands that act on each particle by itself (TS_RANKS_ROWS) change
 * those of each rank. */
#ifndef TS_CORE_RANKS_PAUSE_H
#define TS_CORE_RANKS_PAUSE_H

#include "core/plan.h"

/* After a run that has left particles divided, or a look: keeps its plan, which is empty then. */
enum ts_status ts_ranks_pause(struct tsim *sim, struct ts_plan *plan);
/* The next run begins, or the simulation ends. */
void ts_ranks_end_pause(struct tsim *sim);
/* All ranks get a look at all particles, if the last run has left them divided. */
enum ts_status ts_ranks_look(struct tsim *sim);
/* The same for a name that depends on particles; an error while formulas of commands are evaluated that are also evaluated in
 * steps: ts_ranks_apart. */
enum ts_status ts_ranks_require_all(struct tsim *sim, const char *name, const struct ts_place *where);
/* All ranks get all particles and lists, if the last run has left something else. */
enum ts_status ts_ranks_unite(struct tsim *sim);

/* Whether there has been no run since particles were read divided from a file; plan: that of the pause, or NULL. */
bool ts_ranks_have_read(const struct ts_plan *plan);
/* The instance is deleted in a pause. */
void ts_ranks_forget(struct tsim *sim, const struct ts_instance *inst);

#endif
