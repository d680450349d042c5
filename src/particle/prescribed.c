#include "particle/prescribed.h"

#include <math.h>

#include "core/ranks.h"
#include "math/vec3.h"

#include "base/banned.h"

uint32_t ts_prescribed(const struct tsim *sim)
{
	const struct ts_instance *fix;
	uint32_t groups = 0;

	for (size_t k = 0; (fix = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_PRESCRIBED, &k));)
		if (!((const struct ts_prescribed_motion *)fix->state)->free)
			groups |= (uint32_t)1 << fix->group;
	return groups;
}

double ts_prescribed_max_speed(const struct tsim *sim, int group)
{
	const struct ts_particles *p = sim->particles;
	double most = 0;

	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, group))
			most = fmax(most, ts_dot(p->v[i], p->v[i]));
	return sqrt(ts_ranks_most(sim, most));
}
