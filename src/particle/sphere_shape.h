/* Volume and moment of inertia of a particle: a sphere, or in two dimensions a disc. Used wherever
 * density and mass are converted. */
#ifndef TS_PARTICLE_SPHERE_SHAPE_H
#define TS_PARTICLE_SPHERE_SHAPE_H

#include "core/sim.h"
#include "math/constants.h"
#include "particle/particles.h"

/* 4/3 pi r^3, or in two dimensions the area pi r^2, where densities are masses per area. */
static inline double ts_particle_volume(const struct tsim *sim, double radius)
{
	if (sim->dimension == 2)
		return TS_PI * radius * radius;
	return 4.0 / 3.0 * TS_PI * radius * radius * radius;
}

/* Moment of inertia divided by m r^2: 2/5 for a sphere, 1/2 for a disc about its axis. */
static inline double ts_inertia_factor(const struct tsim *sim)
{
	enum ts_inertia shape = sim->particles->inertia;

	if (shape == TS_INERTIA_BY_DIMENSION)
		shape = sim->dimension == 2 ? TS_INERTIA_DISC : TS_INERTIA_SPHERE;
	return shape == TS_INERTIA_DISC ? 0.5 : 0.4;
}

/* Moment of inertia of particle i. */
static inline double ts_inertia(const struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;

	return ts_inertia_factor(sim) * p->mass[i] * p->radius[i] * p->radius[i];
}

#endif
