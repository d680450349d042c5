/* How long a step of the fluid may be: see limits.c. */
#ifndef TS_FLOW_FLOW_LIMITS_H
#define TS_FLOW_FLOW_LIMITS_H

#include "flow/projection.h"

/* Longest steps; INFINITY where there is no limit. */
struct ts_flow_limits {
	double viscous; /* by the decay of the shortest waves */
	double courant; /* by sum |u|/h */
	double growth;	/* by slow growth of waves that convection moves and viscosity does not damp */
};
struct ts_flow_limits ts_flow_limits(const struct ts_projection *projection);
/* That of a fluid at rest. */
double ts_flow_viscous_limit(const struct ts_projection *projection);
/* The least of them. */
double ts_flow_limit(const struct ts_projection *projection);

#endif
