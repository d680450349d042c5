/* Compute com: center of mass. */
#include "base/axes.h"
#include "core/sim.h"

#include "math/exactsum.h"
#include "particle/group_moments.h"

#include "base/banned.h"

/* Sums are exact; positions are unwrapped. */
static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_particles *p = sim->particles;
	struct ts_exactsum mass = ts_exactsum_start(), moment[3];
	double x[3];

	for (int d = 0; d < 3; d++)
		moment[d] = ts_exactsum_start();
	for (size_t i = 0; i < p->n; i++) {
		if (!ts_in_group(p, i, self->group))
			continue;
		ts_exactsum_add(&mass, p->mass[i]);
		ts_unwrapped(sim, i, x);
		for (int d = 0; d < 3; d++)
			ts_exactsum_add(&moment[d], p->mass[i] * x[d]);
	}
	for (int d = 0; d < 3; d++)
		out->data[d] = ts_exactsum_value(&mass) > 0
				       ? ts_exactsum_value(&moment[d]) / ts_exactsum_value(&mass)
				       : 0;
	return TS_OK;
}

static const struct ts_value values[] = {
	{ .name = "center",
	  .unit = "length",
	  .help = "center of mass of the group, unwrapped",
	  .shape = TS_VECTOR,
	  .columns = 3,
	  .column_names = ts_axis_names,
	  .eval = eval },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_com)
const struct ts_style ts_compute_com = {
	.name = "com",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Center of mass",
	.doc = "c_ID[1], c_ID[2] and c_ID[3] are the components of sum(m x)/sum(m) over the group, where x "
	       "are unwrapped positions. They are 0 for an empty group.",
	.example = "compute center all com",
	.values = values,
};
