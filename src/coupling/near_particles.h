/* Whether the particles of a rank are near enough for what it has of the fluid (flow/fluid_near.h). */
#ifndef TS_COUPLING_NEAR_PARTICLES_H
#define TS_COUPLING_NEAR_PARTICLES_H

#include "flow/fluid.h"

/* All ranks call it: value[k] becomes the largest of all ranks, as by ts_ranks_most_of, and all get what their particles need of
 * the fluid in this step. */
enum ts_status ts_near_particles_agree(struct ts_fluid *fluid, struct tsim *sim, double *value, size_t n);
/* In a hook that reads the fluid at particles, before it does: the same, if it has not been called in this step. fluid NULL:
 * none is solved for. */
enum ts_status ts_near_particles_ready(struct ts_fluid *fluid, struct tsim *sim);
/* Particles add to cells up to `reach` beyond their own: the same number on all ranks. */
void ts_near_particles_reach(struct ts_fluid *fluid, int reach);

#endif
