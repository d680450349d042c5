#include "particle/weight.h"

#include "base/banned.h"

const char *const ts_weight_names[] = { "number", "mass", "volume", NULL };

double ts_particle_weight(const struct tsim *sim, enum ts_weight weight, size_t i)
{
	if (weight == TS_WEIGHT_NUMBER)
		return 1;
	return weight == TS_WEIGHT_MASS ? sim->particles->mass[i]
					: ts_particle_volume(sim, sim->particles->radius[i]);
}
