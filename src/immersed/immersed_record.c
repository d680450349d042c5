#include "immersed/immersed_record.h"

#include "base/banned.h"

void ts_immersed_record_update(struct ts_immersed_record *r, const struct ts_immersed_sums *sums,
			       double density, double share, double length, double depth)
{
	const double part = r->known > TS_IMMERSED_INSIDE ? share : 1;

	for (int k = 0; k < 3; k++) {
		double rate = (sums->velocity[k] - r->velocity[k]) / length;
		double turn = (sums->spin[k] - r->spin[k]) / length;
		double force = density * sums->volume * rate - sums->impulse[k] / length;
		double torque = density * sums->volume * turn - sums->angular_impulse[k] / length;

		r->force[k] += part * (force / depth - r->force[k]);
		r->torque[k] += part * (torque / depth - r->torque[k]);
		r->velocity[k] = sums->velocity[k];
		r->spin[k] = sums->spin[k];
	}
	r->known = 1;
}
