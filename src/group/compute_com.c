/* Compute com: center of mass. */
#include "base/axes.h"
#include "core/sim.h"

#include "group/group_motion.h"

#include "base/banned.h"

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	ts_group_centre(sim, self->group, out->data);
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
	       "are unwrapped positions; a clump (fix multisphere) counts at its centre of mass. They are 0 "
	       "for an empty group.",
	.example = "compute center all com",
	.values = values,
};
