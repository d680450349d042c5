/* Steps of the fluid that ranks divide: each computes a slab, planes across the last axis. */
#ifndef TS_FLOW_SLAB_STEP_H
#define TS_FLOW_SLAB_STEP_H

#include "flow/projection.h"

/* Whether so many ranks divide the steps of this grid; else each computes all of it. */
bool ts_slab_step_divides(const struct ts_projection *projection, int ranks);

/* Before a step, while the particles are divided among ranks into these blocks (NULL: they are not): chooses the planes
 * that a rank has, and what it has near its particles. */
enum ts_status ts_slab_step_begin(struct ts_projection *projection, const struct tsim *sim,
				  const struct ts_rank_blocks *blocks);
/* The same; planes that are not needed take no memory any more. */
enum ts_status ts_slab_step_begin_apart(struct ts_projection *projection, const struct tsim *sim,
					const struct ts_rank_blocks *blocks);
/* In the set-up of a run: the same; what is near particles is got when a fix first reads it. */
enum ts_status ts_slab_step_set_up(struct ts_projection *projection, const struct tsim *sim,
				   const struct ts_rank_blocks *blocks);
/* A fluid that ranks have in some planes only stays divided. */
void ts_slab_step_end(struct ts_projection *projection);
/* All ranks get all planes of the fluid. */
void ts_slab_step_complete(struct ts_projection *projection, const struct tsim *sim);
/* While ranks have planes, and particles: all get the fields near their particles, if the blocks, or how far that is, have
 * changed; those that a step has computed; what they send for it is counted (rank/rehearsal.h). */
enum ts_status ts_slab_step_renew(struct ts_projection *projection, const struct tsim *sim,
				  const struct ts_rank_blocks *blocks);
enum ts_status ts_slab_step_spread(struct ts_projection *projection, const struct tsim *sim);
void ts_slab_step_count_spread(struct ts_projection *projection, const struct tsim *sim);
/* After the pressure solver has been chosen: all ranks get all planes if they do not divide it. Returns whether they have got them. */
bool ts_slab_step_check_solver(struct ts_projection *projection, const struct tsim *sim);

/* All do nothing while ranks do not have slabs. After the predictor, or what fixes have changed of it: velocities that the
 * divergence needs; if they are still to change them, those of all planes, unless ranks have some planes only. */
void ts_slab_step_predicted(struct ts_projection *projection, bool to_change);
/* The pressure of all planes, or what the correction of the velocity needs of a field of which a rank has its own planes. */
void ts_slab_step_solved(struct ts_projection *projection, double *pressure);
/* The velocities of all planes, or those that the next predictor needs. */
void ts_slab_step_corrected(struct ts_projection *projection);
/* All planes of a field. */
void ts_slab_step_share(struct ts_projection *projection, double *field);

#endif
