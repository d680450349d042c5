/* Compute ke: translational kinetic energy. */
#include "group/kinetic_energy.h"

#include "base/banned.h"

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	out->data[0] = ts_group_kinetic_energy(sim, self->group);
	return TS_OK;
}

static const struct ts_value values[] = {
	{ .name = "energy",
	  .unit = "energy",
	  .help = "translational kinetic energy of the group",
	  .shape = TS_SCALAR,
	  .eval = eval },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_ke)
const struct ts_style ts_compute_ke = {
	.name = "ke",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES | TS_RANKS_SUMS,
	.summary = "Translational kinetic energy",
	.doc = "Sum of m v^2 / 2 over the group, without rotation (see compute erotate/sphere). The sum is "
	       "exact and rounded once, so it does not depend on the order of particles. A clump of fix "
	       "multisphere counts as one particle.",
	.example = "compute energy all ke",
	.values = values,
};
