/* Added mass of particles that are smaller than the cells of the fluid (fix added_mass), for drag fixes
 * that relax the velocity. The inertia of the fluid around resolved bodies is another matter:
 * immersed/virtual_mass_stabilization.h. */
#ifndef TS_COUPLING_ADDED_MASS_H
#define TS_COUPLING_ADDED_MASS_H

#include "coupling/coupling_force.h"
#include "particle/particles.h"

/* First member of the state of fix added_mass. */
struct ts_added_mass {
	struct ts_coupling_force force; /* first */
	double coefficient;		/* added mass by displaced mass */
	bool accelerates;		/* Du/Dt is part of it */
};

/* Added mass per volume of particle, by group; groups of several fixes have no particle in common. */
struct ts_added_masses {
	size_t n;
	struct {
		int group;
		double density;
		bool follows, reacts; /* the acceleration of the fluid; the opposite force acts on it */
	} of[32];
};

/* Finds all fixes added_mass. A flow style exists. */
struct ts_added_masses ts_added_mass_find(const struct tsim *sim);

static inline double ts_added_mass_density(const struct ts_added_masses *added, const struct ts_particles *p,
					   size_t i)
{
	double density = 0;

	for (size_t k = 0; k < added->n; k++)
		if (ts_in_group(p, i, added->of[k].group))
			density += added->of[k].density;
	return density;
}

#endif
