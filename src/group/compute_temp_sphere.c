/* Compute temp/sphere: temperature of translation and rotation. */
#include "core/units.h"
#include "group/temperature.h"
#include "math/vec3.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

enum motion { ALL, ROTATE };
static const char *const motions[] = { [ALL] = "all", [ROTATE] = "rotate", NULL };

struct temp_sphere {
	struct ts_freedom freedom; /* first: see group/temperature.h */
	int motion;
};

/* Terms of the kinetic tensor, m v_a v_b + I w_a w_b, and the degrees of freedom of the particle. */
static void sphere_terms(const struct tsim *sim, size_t i, const void *context, double *term)
{
	const struct temp_sphere *c = context;
	const struct ts_particles *p = sim->particles;
	double mass = c->motion == ALL ? p->mass[i] : 0, inertia = p->omega ? ts_inertia(sim, i) : 0;

	for (int k = 0; k < 6; k++) {
		int a = ts_tensor_row[k], b = ts_tensor_column[k];

		term[k] = mass * p->v[i][a] * p->v[i][b];
		if (p->omega)
			term[k] += inertia * p->omega[i][a] * p->omega[i][b];
	}
	term[6] = sim->dimension == 3 ? 3 : 1;
	if (c->motion == ALL)
		term[6] += sim->dimension;
}

static enum ts_status eval_temperature(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct temp_sphere *c = self->state;
	double sum[7], missing = c->motion == ALL ? sim->dimension : 0, freedom;

	ts_group_sum(sim, self->group, 7, sphere_terms, c, sum);
	freedom = sum[6] - (c->freedom.given ? c->freedom.missing : missing);
	out->data[0] = freedom > 0 ? (sum[0] + sum[1] + sum[2]) / (freedom * ts_boltzmann(sim)) : 0;
	return TS_OK;
}

static enum ts_status eval_tensor(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double sum[7];

	ts_group_sum(sim, self->group, 7, sphere_terms, self->state, sum);
	return ts_temperature_write_tensor(sum, out);
}

static const struct ts_arg args[] = {
	TS_ENUM("dof", struct temp_sphere, motion, motions, .fallback = "all",
		.help = "degrees of freedom: all, or those of rotation"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "temperature", "temperature", "temperature of the group", TS_SCALAR, 1, NULL, eval_temperature },
	{ "tensor", "energy", "kinetic tensor: sum of m v_a v_b + I omega_a omega_b", TS_VECTOR, 6,
	  ts_tensor_names, eval_tensor },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_temp_sphere)
const struct ts_style ts_compute_temp_sphere = {
	.name = "temp/sphere",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Temperature of translation and rotation",
	.doc = "T = sum (m v^2 + I omega^2) / (F k_B) over the group, with k_B as in compute temp. F is the "
	       "number of degrees of freedom, 6 of each particle less 3, in two dimensions 3 of each less 2. "
	       "`dof rotate` leaves out the translation: T = sum I omega^2 / (F k_B), where F is 3 of each "
	       "particle, in two dimensions 1. `compute_modify ID extra M` subtracts M instead of the 3, 2 "
	       "or 0. Particles that no style rotates have omega = 0, and count in F as in LAMMPS.\n\n"
	       "The vector is the tensor sum m v_a v_b + I omega_a omega_b for ab = xx, yy, zz, xy, xz, yz, "
	       "with `dof rotate` its second term. `bias` of LAMMPS is not supported: for a group that moves "
	       "as a whole see compute temp/com and compute temp/granular.",
	.example = "compute heat gas temp/sphere",
	.args = args,
	.state_size = sizeof(struct temp_sphere),
	.values = values,
	.modify = ts_freedom_modify,
};
