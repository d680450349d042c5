/* Added mass, for drag fixes that relax the velocity: fix added_mass gives it. */
#ifndef TS_COUPLING_ADDED_MASS_H
#define TS_COUPLING_ADDED_MASS_H

#include "coupling/coupling_force.h"
#include "particle/particles.h"

/* The state of fix added_mass begins so. */
struct ts_added_mass {
	struct ts_coupling_force force; /* first */
	double coefficient;	    /* of the displaced mass */
};

/* Mass per volume that particles take with them, by group: groups of several fixes have no particle in common. */
struct ts_added_masses {
	size_t n;
	struct {
		int group;
		double density;
	} of[32];
};

/* There is a fluid. */
struct ts_added_masses ts_added_mass_find(const struct tsim *sim);

static inline double ts_added_mass_density(const struct ts_added_masses *added, const struct ts_particles *p, size_t i)
{
	double density = 0;

	for (size_t k = 0; k < added->n; k++)
		if (ts_in_group(p, i, added->of[k].group))
			density += added->of[k].density;
	return density;
}

#endif
