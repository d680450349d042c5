/* Added mass, for drag fixes that relax the velocity: fix added_mass gives it. */
#ifndef TS_FLOW_ADDED_MASS_H
#define TS_FLOW_ADDED_MASS_H

#include "flow/fluid.h"

#define TS_ADDED_MASS "added_mass"

/* The state of fix added_mass begins so. */
struct ts_added_mass {
	struct ts_flow_part part;
	double coefficient; /* of the displaced mass */
	double density;	    /* of the fluid */
};

/* Mass that particles of the group take with them, per volume of the particle. */
double ts_added_density(const struct tsim *sim, int group);

#endif
