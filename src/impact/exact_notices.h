/* Particles that `impact exact` leaves to the forces, or that have too many impacts: errors and warnings, the same on any
 * number of ranks. */
#ifndef TS_IMPACT_EXACT_NOTICES_H
#define TS_IMPACT_EXACT_NOTICES_H

#include "impact/exact_impacts.h"

/* A wall that takes part. */
struct ts_exact_target {
	const struct ts_instance *by;
	struct ts_wall *wall;
};

/* What is to be told of a particle, or is left to the forces. */
struct ts_exact_notice {
	int32_t tag, target; /* target: number of the wall among those that take part */
	bool many; /* it has had TS_EXACT_MOST impacts; else its contact is left to the forces: it touches another
				particle in the step, or is in a rigid body */
	bool member; /* of a rigid body */
	double x[3], radius;
	double duration; /* of its collision with the wall, if it were alone; 0: not known */
	double speed;	 /* of approach, normal to the surface */
};

struct ts_exact_notices {
	struct ts_exact_notice *item;
	size_t n, capacity;
};

/* Whether the warning has been given of such a particle, saved. */
double *ts_exact_warned(struct ts_exact_impacts *exact, bool member);
/* Lists the particles that are left to the forces, of all ranks, and tells of them in the order of identities. */
enum ts_status ts_exact_tell(struct tsim *sim, const struct ts_exact_target *target, size_t targets,
			     struct ts_exact_notices *notices);

#endif
