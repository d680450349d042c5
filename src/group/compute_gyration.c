/* Compute gyration: radius and tensor of gyration. */
#include "group/group_motion.h"
#include "particle/group_moments.h"
#include "rigid/mass_moments.h"

#include <math.h>
#include <string.h>

#include "base/banned.h"

/* Terms m (x_a - c_a) (x_b - c_b), and m. */
static void second_moment_terms(const struct tsim *sim, size_t from, size_t n, const void *centre,
				double (*term)[TS_TERM_BLOCK])
{
	ts_mass_second_moment_terms(sim, from, n, centre, term);
	memcpy(term[6], sim->particles->mass + from, n * sizeof *term[6]);
}

static void gyration_tensor(const struct ts_instance *self, const struct tsim *sim, double out[6])
{
	double centre[3], sum[7];

	ts_group_centre(sim, self->group, centre);
	ts_group_sum_blocks(sim, self->group, 7, second_moment_terms, centre, sum);
	for (int k = 0; k < 6; k++)
		out[k] = sum[6] > 0 ? sum[k] / sum[6] : 0;
}

static enum ts_status eval_radius(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double t[6];

	gyration_tensor(self, sim, t);
	out->data[0] = sqrt(t[0] + t[1] + t[2]);
	return TS_OK;
}

static enum ts_status eval_tensor(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	gyration_tensor(self, sim, out->data);
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "radius", "length", "radius of gyration", TS_SCALAR, 1, NULL, eval_radius },
	{ "tensor", "length^2", "gyration tensor; its trace is the square of the radius", TS_VECTOR, 6,
	  ts_tensor_names, eval_tensor },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_gyration)
const struct ts_style ts_compute_gyration = {
	.name = "gyration",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Radius of gyration of a group",
	.doc = "Radius of gyration R of the group with the centre of mass c and unwrapped positions x:\n\n"
	       "    R^2 = sum m (x - c)^2 / sum m\n\n"
	       "The vector is the gyration tensor with the components xx, yy, zz, xy, xz, yz:\n\n"
	       "    G_ab = sum m (x_a - c_a) (x_b - c_b) / sum m\n\n"
	       "Particles are points, as in LAMMPS; a clump (fix multisphere) counts with the distribution "
	       "of its mass. All are 0 for an empty group.",
	.example = "compute size clump gyration",
	.values = values,
};
