/* Compute: kinetic energy of translation. */
#include "core/sim.h"

#include "math/exactsum.h"
#include "math/vec3.h"
#include "particles/particles.h"

#include "base/banned.h"

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_particles *p = sim->particles;
	struct ts_exactsum sum = ts_exactsum_start();

	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			ts_exactsum_add(&sum, 0.5 * p->mass[i] * ts_dot(p->v[i], p->v[i]));
	out->data[0] = ts_exactsum_value(&sum);
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
	.doc = "The sum of m v^2 / 2 over the group, rounded once, so that it does not depend on "
	       "the order\n"
	       "of the particles. Rotation is not in it.",
	.example = "compute energy all ke",
	.values = values,
};
