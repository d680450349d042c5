#include "immersed/immersed_record.h"

#include "base/banned.h"

void ts_immersed_record_update(struct ts_immersed_record *r, const struct ts_immersed_sums *sums,
			       const struct ts_fluid *fluid, double share, double length, double depth)
{
	const double part = r->known > TS_IMMERSED_INSIDE ? share : 1;
	const double mass = fluid->density * sums->volume;
	double rate[3], turn[3];

	for (int k = 0; k < 3; k++) {
		rate[k] = (sums->velocity[k] - r->velocity[k]) / length - ts_immersed_weight(fluid, k);
		turn[k] = (sums->spin[k] - r->spin[k]) / length;
	}
	for (int k = 0; k < 3; k++) { /* impulses have arms from the centre, `spin` from the mean position */
		int a = (k + 1) % 3, b = (k + 2) % 3;

		turn[a] += sums->arm[k][b] * rate[k];
		turn[b] -= sums->arm[k][a] * rate[k];
	}
	for (int k = 0; k < 3; k++) {
		double force = mass * rate[k] - sums->impulse[k] / length;
		double torque = mass * turn[k] - sums->angular_impulse[k] / length;

		r->force[k] += part * (force / depth - r->force[k]);
		r->torque[k] += part * (torque / depth - r->torque[k]);
		r->velocity[k] = sums->velocity[k];
		r->spin[k] = sums->spin[k];
	}
	r->known = 1;
}
