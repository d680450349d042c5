/* What is kept of a part of a solid from one step of the fluid to the next: forces, and the fluid inside. */
#ifndef TS_IMMERSED_IMMERSED_RECORD_H
#define TS_IMMERSED_IMMERSED_RECORD_H

#include "immersed/immersed.h"

struct ts_immersed_record {
	double force[3], torque[3];  /* of the fluid on the part */
	double velocity[3], spin[3]; /* of the fluid inside (struct ts_immersed_sums) */
	double known;		     /* 0: nothing is set; TS_IMMERSED_INSIDE: velocity and spin; 1: all */
};
#define TS_IMMERSED_INSIDE 0.5

/* Updates force and torque, per `depth`, from the forcing, the change of the fluid inside and its weight in a step of
 * `length`; of the old ones 1 - share remains. */
void ts_immersed_record_update(struct ts_immersed_record *r, const struct ts_immersed_sums *sums,
			       const struct ts_fluid *fluid, double share, double length, double depth);

#endif
