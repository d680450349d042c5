/* Steps of the fluid that ranks divide: each computes a slab, planes across the last axis. */
#ifndef TS_FLOW_SLAB_STEP_H
#define TS_FLOW_SLAB_STEP_H

#include "flow/projection.h"

/* Whether so many ranks divide the steps of this grid; else each computes all of it. */
bool ts_slab_step_divides(const struct ts_projection *projection, int ranks);

/* Before a step, while the particles are divided among ranks, and in the set-up: chooses the planes that a rank has. Returns whether
 * it has had all until now, and needs these only. */
bool ts_slab_step_begin(struct ts_projection *projection, const struct tsim *sim);
/* Planes of other ranks take no memory any more. */
void ts_slab_step_forget(struct ts_projection *projection);
/* A fluid that ranks have in some planes only stays divided. */
void ts_slab_step_end(struct ts_projection *projection);
/* All ranks get all planes of the fluid. */
void ts_slab_step_complete(struct ts_projection *projection);
/* After the pressure solver has been chosen: one that ranks do not divide needs all planes. */
void ts_slab_step_check_solver(struct ts_projection *projection, const struct tsim *sim);

/* All do nothing while ranks do not have slabs. After the predictor: velocities that the divergence needs; those of all
 * planes if fixes change them. */
void ts_slab_step_predicted(struct ts_projection *projection, bool all);
/* The pressure of all planes, or what the correction of the velocity needs of a field of which a rank has its own planes. */
void ts_slab_step_solved(struct ts_projection *projection, double *pressure);
/* The velocities of all planes, or those that the next predictor needs. */
void ts_slab_step_corrected(struct ts_projection *projection);
/* All planes of a field. */
void ts_slab_step_share(struct ts_projection *projection, double *field);

#endif
