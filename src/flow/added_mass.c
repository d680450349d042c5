#include "flow/added_mass.h"

#include "base/banned.h"

double ts_added_density(const struct tsim *sim, int group)
{
	const struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW), *inst;
	size_t k = 0;

	while ((inst = ts_flow_part_named(sim, "added_mass", &k)))
		if (inst->group == 0 || inst->group == group)
			return ((const struct ts_added_mass *)inst->state)->coefficient *
			       ts_flow_style_of(flow)->density(flow);
	return 0;
}
