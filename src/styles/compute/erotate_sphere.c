/* Compute: kinetic energy of rotation. */
#include "particles/moments.h"

#include "math/vec3.h"
#include "particles/body.h"

#include "base/banned.h"

static void rotational(const struct tsim *sim, size_t i, void *context, double *term)
{
	const struct ts_particles *p = sim->particles;

	(void)context;
	term[0] = 0.5 * ts_inertia(sim, i) * ts_dot(p->omega[i], p->omega[i]);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	out->data[0] = 0;
	if (sim->particles->omega)
		ts_group_sum(sim, self->group, 1, rotational, NULL, out->data);
	return TS_OK;
}

static const struct ts_value values[] = {
	{ .name = "energy",
	  .unit = "energy",
	  .help = "kinetic energy of rotation of the group",
	  .shape = TS_SCALAR,
	  .eval = eval },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_erotate_sphere)
const struct ts_style ts_compute_erotate_sphere = {
	.name = "erotate/sphere",
	.kind = TS_KIND_COMPUTE,
	.summary = "Kinetic energy of rotation",
	.doc = "The sum of I omega^2 / 2 over the group with I = 0.4 m R^2 (0.5 m R^2 for discs), rounded once. It is 0 where "
	       "nothing\n"
	       "makes particles rotate.",
	.example = "compute rotation all erotate/sphere",
	.values = values,
};
