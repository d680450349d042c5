/* Compute temp: temperature of the translational motion. */
#include "group/temperature.h"

#include "base/banned.h"

static enum ts_status eval_temperature(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double sum[7];

	ts_temperature_tensor(sim, self->group, NULL, sum);
	out->data[0] = ts_temperature(sim, sum, self->state);
	return TS_OK;
}

static enum ts_status eval_tensor(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double sum[7];

	ts_temperature_tensor(sim, self->group, NULL, sum);
	return ts_temperature_write_tensor(sum, out);
}

static const struct ts_value values[] = {
	{ "temperature", "temperature", "temperature of the group", TS_SCALAR, 1, NULL, eval_temperature },
	{ "tensor", "energy", "kinetic tensor: sum of m v_a v_b", TS_VECTOR, 6, ts_tensor_names,
	  eval_tensor },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_temp)
const struct ts_style ts_compute_temp = {
	.name = "temp",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Temperature of the translational motion",
	.doc = "T = sum m v^2 / (D (N - 1) k_B) for the N particles of the group in D dimensions, where k_B "
	       "is 1 in lj units and 1.380649e-23 in si units. It is 0 without degrees of freedom. "
	       "`compute_modify ID extra M` replaces the D (N - 1) degrees of freedom by D N - M. "
	       "Particles of rigid bodies count like free ones.\n\n"
	       "The vector is the kinetic tensor sum m v_a v_b for ab = xx, yy, zz, xy, xz, yz; its trace is "
	       "twice the kinetic energy.\n\n"
	       "Of grains in SI units T is some 1e12 K. The fluctuations of their velocities are measured by "
	       "the granular temperature, in velocity^2: compute temp/granular.",
	.example = "compute heat gas temp",
	.state_size = sizeof(struct ts_freedom),
	.values = values,
	.modify = ts_freedom_modify,
};
