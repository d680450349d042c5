/* Compute: temperature of the translation. */
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
	for (int k = 0; k < 6; k++)
		out->data[k] = sum[k];
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "temperature", "temperature", "of the translation of the group", TS_SCALAR, 1, NULL,
	  eval_temperature },
	{ "tensor", "energy", "sum of m u_a u_b", TS_VECTOR, 6, ts_tensor_names, eval_tensor },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_temp)
const struct ts_style ts_compute_temp = {
	.name = "temp",
	.kind = TS_KIND_COMPUTE,
	.summary = "Temperature of the translation",
	.doc = "T = sum m u^2 / (D (N - 1) k_B), u = v, for N particles of the group in D dimensions. k_B is "
	       "1 in lj units\nand 1.380649e-23 in si. The list has sum m u_a u_b for ab = xx, yy, zz, xy, "
	       "xz, yz: twice the kinetic\nenergy in its trace. Without degrees of freedom T is 0. "
	       "`compute_modify ID extra M` makes of D (N - 1)\ndegrees of freedom D N - M.",
	.example = "compute heat gas temp",
	.state_size = sizeof(struct ts_freedom),
	.values = values,
	.modify = ts_freedom_modify,
};
