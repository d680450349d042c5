/* Compute: kinetic energy of translation. */
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
	  .help = "kinetic energy of the group",
	  .shape = TS_SCALAR,
	  .eval = eval },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_ke)
const struct ts_style ts_compute_ke = {
	.name = "ke",
	.kind = TS_KIND_COMPUTE,
	.summary = "Kinetic energy of translation",
	.doc = "The sum of m v^2 / 2 over the group, rounded once, so that it does not depend on the order\n"
	       "of the particles. Rotation is not in it. A clump of fix\n"
	       "multisphere counts as one particle.",
	.example = "compute energy all ke",
	.values = values,
};
