/* What ranks send in a step of the fluid, counted without starting them and without computing the step. */
#ifndef TS_FLOW_STEP_REHEARSAL_H
#define TS_FLOW_STEP_REHEARSAL_H

#include "flow/projection.h"

struct ts_rank_layout;

enum { TS_REHEARSED_MOST = 4096 }; /* ranks: the work grows as their square */

/* `count` of struct ts_report_rehearsal, for steps without outputs: those of the simulation for one of the fluid. The work
 * fields of the fluid lose their values. */
enum ts_status ts_projection_rehearse(struct ts_instance *self, struct tsim *sim,
				      const struct ts_rank_layout *layout, int iterations,
				      struct ts_world_counts *sent);

#endif
