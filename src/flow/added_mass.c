#include "flow/added_mass.h"

#include <string.h>

#include "base/banned.h"

double ts_added_density(const struct tsim *sim, int group)
{
	const struct ts_instance *inst;
	size_t k = 0;

	while ((inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k))) {
		const struct ts_added_mass *mass = inst->state;

		if (strcmp(inst->style->name, "added_mass") == 0 &&
		    (inst->group == 0 || inst->group == group))
			return mass->coefficient *
			       ts_flow_style_of(mass->force.flow)->density(mass->force.flow);
	}
	return 0;
}
