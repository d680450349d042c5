/* What ranks send in a step of the fluid, counted without starting them and without computing the step. */
#ifndef TS_FLOW_STEP_REHEARSAL_H
#define TS_FLOW_STEP_REHEARSAL_H

#include "flow/projection.h"

enum { TS_REHEARSED_MOST = 4096 }; /* ranks: the work grows as their square */

/* Adds to sent[r] what the rank with block r sends in a step without outputs, with so many iterations in each solve for the
 * pressure. *near: ranks have the fluid near their particles only, and what particles add to cells is counted, too. The work
 * fields of the fluid lose their values. */
enum ts_status ts_projection_rehearse(struct ts_instance *self, struct tsim *sim,
				      const struct ts_rank_blocks *blocks, int iterations,
				      struct ts_world_counts *sent, bool *near);

/* The planes of the grid, ghosts included, that a rank has in memory, at most: of all fields, and of those that particles read or add to
 * (flow/fluid_fields.h); all if ranks do not divide it. */
struct ts_rehearsed_planes {
	int all, near;
};
enum ts_status ts_projection_rehearse_planes(struct ts_instance *self, struct tsim *sim,
					     const struct ts_rank_blocks *blocks,
					     struct ts_rehearsed_planes *planes);

#endif
