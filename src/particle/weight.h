/* What particles are counted by in distributions and concentrations. */
#ifndef TS_PARTICLE_WEIGHT_H
#define TS_PARTICLE_WEIGHT_H

#include "particle/particles.h"
#include "particle/sphere_shape.h"

enum ts_weight { TS_WEIGHT_NUMBER, TS_WEIGHT_MASS, TS_WEIGHT_VOLUME };
extern const char *const ts_weight_names[]; /* for argument tables, NULL-terminated */

/* 1, the mass or the volume of particle i. */
double ts_particle_weight(const struct tsim *sim, enum ts_weight weight, size_t i);

#endif
