/* Compute erotate/sphere/atom: rotational kinetic energy of each particle. */
#include "group/kinetic_energy.h"
#include "particle/particles.h"

#include "base/banned.h"

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_table_resize(out, p->n, 1));
	for (size_t i = 0; i < p->n; i++)
		out->data[i] = ts_in_group(p, i, self->group) ? ts_kinetic_energy_rotation(sim, i) : 0;
	return TS_OK;
}

static const struct ts_value values[] = {
	{ .name = "energy",
	  .unit = "energy",
	  .help = "rotational kinetic energy; 0 for particles outside the group",
	  .shape = TS_PERATOM,
	  .columns = 1,
	  .eval = eval },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_erotate_sphere_atom)
const struct ts_style ts_compute_erotate_sphere_atom = {
	.name = "erotate/sphere/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Rotational kinetic energy of each particle",
	.doc = "I omega^2 / 2 with I = 0.4 m R^2 (0.5 m R^2 for discs). It is 0 if no style of the script "
	       "makes particles rotate, and for the spheres of a clump: see compute erotate/multisphere.",
	.example = "compute rotation all erotate/sphere/atom",
	.values = values,
};
