/* Compute temp/com: temperature of the motion relative to the centre of mass. */
#include "group/group_motion.h"
#include "group/temperature.h"

#include "base/banned.h"

static enum ts_status eval_temperature(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double sum[7], mean[3];

	ts_group_velocity(sim, self->group, mean);
	ts_temperature_tensor(sim, self->group, mean, sum);
	out->data[0] = ts_temperature(sim, sum, self->state);
	return TS_OK;
}

static enum ts_status eval_tensor(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double sum[7], mean[3];

	ts_group_velocity(sim, self->group, mean);
	ts_temperature_tensor(sim, self->group, mean, sum);
	return ts_temperature_write_tensor(sum, out);
}

static const struct ts_value values[] = {
	{ "temperature", "temperature", "temperature relative to the centre of mass", TS_SCALAR, 1, NULL,
	  eval_temperature },
	{ "tensor", "energy", "kinetic tensor: sum of m u_a u_b", TS_VECTOR, 6, ts_tensor_names,
	  eval_tensor },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_temp_com)
const struct ts_style ts_compute_temp_com = {
	.name = "temp/com",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Temperature relative to the centre of mass",
	.doc = "As compute temp for the velocities u relative to the velocity of the centre of mass of the "
	       "group. Multiplied by k_B / m, with m the mass of a grain, it is the granular temperature of "
	       "a cloud of equal grains with a mean velocity, which compute temp/granular gives directly.",
	.example = "compute heat gas temp/com",
	.state_size = sizeof(struct ts_freedom),
	.values = values,
	.modify = ts_freedom_modify,
};
