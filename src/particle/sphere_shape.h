/* What shape a particle of a given radius is: a sphere, or in two dimensions a disc. The one place that
 * knows the volume its density refers to and its moment of inertia. */
#ifndef TS_PARTICLE_SPHERE_SHAPE_H
#define TS_PARTICLE_SPHERE_SHAPE_H

#include "core/sim.h"
#include "math/constants.h"
#include "particle/particles.h"

/* 4 pi r^3 / 3, or in two dimensions the area pi r^2: densities are then masses per area. */
static inline double ts_particle_volume(const struct tsim *sim, double radius)
{
	if (sim->dimension == 2)
		return TS_PI * radius * radius;
	return 4.0 / 3.0 * TS_PI * radius * radius * radius;
}

/* Moment of inertia in m r^2: 2/5 of a sphere, 1/2 of a disc about its axis. */
static inline double ts_inertia_factor(const struct tsim *sim)
{
	enum ts_inertia shape = sim->particles->inertia;

	if (shape == TS_INERTIA_BY_DIMENSION)
		shape = sim->dimension == 2 ? TS_INERTIA_DISC : TS_INERTIA_SPHERE;
	return shape == TS_INERTIA_DISC ? 0.5 : 0.4;
}

static inline double ts_inertia(const struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;

	return ts_inertia_factor(sim) * p->mass[i] * p->radius[i] * p->radius[i];
}

#endif
