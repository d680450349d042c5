/* Direction and magnitude of gravity for other styles (buoyancy, fluids): given by fix gravity. */
#ifndef TS_FORCE_GRAVITY_H
#define TS_FORCE_GRAVITY_H

#include "core/sim.h"

#define TS_FAMILY_GRAVITY "gravity"

/* First member of the state of styles of that family. */
struct ts_gravity {
	struct ts_number magnitude;
	double direction[3]; /* unit vector, at present */
	bool turns;	     /* the direction is given by variables */
};

#endif
