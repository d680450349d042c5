#include "coupling/added_mass.h"

#include "base/banned.h"

struct ts_added_masses ts_added_mass_find(const struct tsim *sim)
{
	const struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW), *inst;
	struct ts_added_masses added = { 0 };

	for (size_t k = 0; added.n < sizeof added.of / sizeof *added.of &&
			   (inst = ts_flow_part_named(sim, "added_mass", &k));
	     added.n++) {
		const struct ts_added_mass *mass = inst->state;

		added.of[added.n].group = inst->group;
		added.of[added.n].density = mass->coefficient * ts_flow_style_of(flow)->density(flow);
		added.of[added.n].follows = mass->accelerates;
		added.of[added.n].reacts = mass->force.two_way;
	}
	return added;
}
