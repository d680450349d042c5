/* Added mass, for drag fixes that relax the velocity: fix added_mass gives it. */
#ifndef TS_FLOW_ADDED_MASS_H
#define TS_FLOW_ADDED_MASS_H

#include "flow/flow_force.h"

/* The state of fix added_mass begins so. */
struct ts_added_mass {
	struct ts_flow_force force; /* first */
	double coefficient;	    /* of the displaced mass */
};

/* Mass that particles of the group take with them, per volume of the particle; there is a fluid. */
double ts_added_density(const struct tsim *sim, int group);

#endif
