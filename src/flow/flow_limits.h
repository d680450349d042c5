/* Stability limits of the time step of the fluid. */
#ifndef TS_FLOW_FLOW_LIMITS_H
#define TS_FLOW_FLOW_LIMITS_H

#include "flow/projection.h"

/* Largest stable steps (time units); INFINITY if there is no limit. */
struct ts_flow_limits {
	double viscous; /* explicit viscosity, and decay of the shortest waves by the convection scheme */
	double courant; /* Courant number, sum |u| dt/h */
	double growth;	/* slow growth of waves that are convected and not damped by viscosity */
};
struct ts_flow_limits ts_flow_limits(const struct ts_projection *projection);
/* The viscous limit of a fluid at rest. */
double ts_flow_viscous_limit(const struct ts_projection *projection);
/* The smallest of the limits. */
double ts_flow_limit(const struct ts_projection *projection);

#endif
