/* Compute ke/atom: translational kinetic energy of each particle. */
#include "group/kinetic_energy.h"
#include "particle/particles.h"

#include "base/banned.h"

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_table_resize(out, p->n, 1));
	for (size_t i = 0; i < p->n; i++)
		out->data[i] = ts_in_group(p, i, self->group) ? ts_kinetic_energy(sim, i) : 0;
	return TS_OK;
}

static const struct ts_value values[] = {
	{ .name = "energy",
	  .unit = "energy",
	  .help = "translational kinetic energy; 0 for particles outside the group",
	  .shape = TS_PERATOM,
	  .columns = 1,
	  .eval = eval },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_ke_atom)
const struct ts_style ts_compute_ke_atom = {
	.name = "ke/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Translational kinetic energy of each particle",
	.doc = "m v^2 / 2 of each particle of the group, without rotation (see compute erotate/sphere/atom). "
	       "For the spheres of a clump v is the velocity of its centre of mass.",
	.example = "compute energy all ke/atom",
	.values = values,
};
