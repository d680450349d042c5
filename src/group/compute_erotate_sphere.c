/* Compute erotate/sphere: rotational kinetic energy. */
#include "group/kinetic_energy.h"

#include "base/banned.h"

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	out->data[0] = ts_group_rotation_energy(sim, self->group);
	return TS_OK;
}

static const struct ts_value values[] = {
	{ .name = "energy",
	  .unit = "energy",
	  .help = "rotational kinetic energy of the group",
	  .shape = TS_SCALAR,
	  .eval = eval },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_erotate_sphere)
const struct ts_style ts_compute_erotate_sphere = {
	.name = "erotate/sphere",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES | TS_RANKS_SUMS,
	.summary = "Rotational kinetic energy",
	.doc = "Sum of I omega^2 / 2 over the group with I = 0.4 m R^2 (0.5 m R^2 for discs). The sum is "
	       "exact and rounded once. It is 0 if no style of the script makes particles rotate. Spheres of "
	       "clumps of fix multisphere are not included: see compute erotate/multisphere.",
	.example = "compute rotation all erotate/sphere",
	.values = values,
};
