/* What ranks send in a step of the fluid, counted without starting them and without computing the step. */
#ifndef TS_FLOW_STEP_REHEARSAL_H
#define TS_FLOW_STEP_REHEARSAL_H

#include "flow/projection.h"

enum { TS_REHEARSED_MOST = 4096 }; /* ranks: the work grows as their square */

/* Adds to sent[r] what rank r sends in a step without outputs, with so many iterations in each solve for the pressure. The work
 * fields of the fluid lose their values. */
enum ts_status ts_projection_rehearse(struct ts_instance *self, struct tsim *sim, int ranks, int iterations,
				      struct ts_world_counts *sent);

/* The planes of the grid, ghosts included, that each rank has in memory, at most; all if ranks do not divide it. */
enum ts_status ts_projection_rehearse_planes(struct ts_instance *self, struct tsim *sim, int ranks,
					     int *planes);

#endif
