/* Momentum exchange of particles with the fluid: the fields f and k (flow/fluid.h) in predictor and
 * projection. */
#ifndef TS_FLOW_PARTICLE_SOURCES_H
#define TS_FLOW_PARTICLE_SOURCES_H

#include "core/sim.h"

struct ts_projection;

/* Computes the weights of the faces in the projection of a stage of length dt. */
enum ts_status ts_projection_face_weights(struct ts_projection *projection, double dt);
/* Applies f and k to the velocity over the time dt. */
void ts_projection_apply_particle_forces(struct ts_projection *projection, double dt);
/* v <- take (carry v + u) with v = exchange_velocity: accumulates over the stages the mean velocity that
 * multiplied k; the same for p_mean. */
void ts_projection_average_exchange(struct ts_projection *projection, double carry, double take);
void ts_projection_clear_sources(struct ts_projection *projection);

#endif
