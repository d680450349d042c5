/* Computes erotate/sphere and erotate: rotational kinetic energy, without and with clumps. */
#include "group/kinetic_energy.h"

#include "base/banned.h"

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	out->data[0] = ts_group_rotation_energy(sim, self->group);
	return TS_OK;
}

static enum ts_status eval_all(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	out->data[0] = ts_group_all_rotation_energy(sim, self->group);
	return TS_OK;
}

#define VALUES(function)                                            \
	{                                                           \
		{ .name = "energy",                                 \
		  .unit = "energy",                                 \
		  .help = "rotational kinetic energy of the group", \
		  .shape = TS_SCALAR,                               \
		  .eval = (function) },                             \
			{ .name = NULL },                           \
	}
static const struct ts_value of_spheres[] = VALUES(eval);
static const struct ts_value of_all[] = VALUES(eval_all);

TS_STYLE(compute, ts_style, ts_compute_erotate_sphere)
const struct ts_style ts_compute_erotate_sphere = {
	.name = "erotate/sphere",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES | TS_RANKS_SUMS,
	.summary = "Rotational kinetic energy",
	.doc = "Sum of I omega^2 / 2 over the group with I = 0.4 m R^2 (0.5 m R^2 for discs). The sum is "
	       "exact and rounded once. It is 0 if no style of the script makes particles rotate. Spheres of "
	       "clumps of fix multisphere are not included: see compute erotate and erotate/multisphere.",
	.example = "compute rotation all erotate/sphere",
	.values = of_spheres,
};

TS_STYLE(compute, ts_style, ts_compute_erotate)
const struct ts_style ts_compute_erotate = {
	.name = "erotate",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES | TS_RANKS_SUMS,
	.summary = "Rotational kinetic energy of spheres and clumps",
	.doc = "The sum of compute erotate/sphere and, for the clumps of fix multisphere, that of compute "
	       "erotate/multisphere: a sphere of a clump has a share of L . omega / 2 in proportion to its "
	       "mass. The keyword erotate of thermo_style is this sum over all particles.",
	.example = "compute rotation all erotate",
	.values = of_all,
};
