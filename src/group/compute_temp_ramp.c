/* Compute temp/ramp: temperature of the motion relative to a velocity that varies linearly. */
#include "base/axes.h"
#include "group/temperature.h"
#include "math/ramp.h"
#include "region/region.h"

#include "base/banned.h"

struct temp_ramp {
	struct ts_freedom freedom; /* first: see group/temperature.h */
	int component, dim, units;
	double v[2], x[2];	     /* velocities and coordinates of both ends, in these units */
	double velocity[2], ends[2]; /* the same, in units of the simulation */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct temp_ramp *c = self->state;

	if (!(c->x[0] < c->x[1]))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "compute temp/ramp: the ends are %g and %g, expected lo < hi", c->x[0],
			       c->x[1]);
	ts_domain_units_said(sim, c->units, &self->where);
	for (int k = 0; k < 2; k++) {
		c->velocity[k] = c->v[k] * ts_domain_scale(sim, c->units, c->component);
		c->ends[k] = c->x[k] * ts_domain_scale(sim, c->units, c->dim);
	}
	return TS_OK;
}

static void less_ramp(const struct tsim *sim, size_t i, const void *context, double u[3])
{
	const struct temp_ramp *c = context;
	const struct ts_particles *p = sim->particles;

	for (int d = 0; d < 3; d++)
		u[d] = p->v[i][d];
	u[c->component] -= ts_ramp(p->x[i][c->dim], c->ends, c->velocity);
}

static enum ts_status eval_temperature(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct temp_ramp *c = self->state;
	double sum[7];

	ts_temperature_tensor_in(sim, self->group, less_ramp, c, sum);
	out->data[0] = ts_temperature(sim, sum, &c->freedom);
	return TS_OK;
}

static enum ts_status eval_tensor(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double sum[7];

	ts_temperature_tensor_in(sim, self->group, less_ramp, self->state, sum);
	return ts_temperature_write_tensor(sum, out);
}

static const char *const components[] = { "vx", "vy", "vz", NULL };
static const struct ts_arg args[] = {
	TS_ENUM("component", struct temp_ramp, component, components, .flags = TS_POSITIONAL,
		.help = "component of the velocity that varies"),
	TS_REAL("vlo", struct temp_ramp, v[0], .flags = TS_POSITIONAL, .unit = "velocity",
		.help = "its value at lo and below"),
	TS_REAL("vhi", struct temp_ramp, v[1], .flags = TS_POSITIONAL, .unit = "velocity",
		.help = "its value at hi and above"),
	TS_ENUM("dim", struct temp_ramp, dim, ts_axis_names, .flags = TS_POSITIONAL,
		.help = "coordinate on which it depends"),
	TS_REAL("lo", struct temp_ramp, x[0], .flags = TS_POSITIONAL, .unit = "length",
		.help = "lower coordinate"),
	TS_REAL("hi", struct temp_ramp, x[1], .flags = TS_POSITIONAL, .unit = "length",
		.help = "upper coordinate"),
	TS_ENUM("units", struct temp_ramp, units, ts_region_units, .flags = TS_OPTIONAL,
		.help = "whether velocities and coordinates are in lattice spacings or in units of length"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "temperature", "temperature", "temperature relative to this velocity", TS_SCALAR, 1, NULL,
	  eval_temperature },
	{ "tensor", "energy", "kinetic tensor: sum of m u_a u_b", TS_VECTOR, 6, ts_tensor_names,
	  eval_tensor },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_temp_ramp)
const struct ts_style ts_compute_temp_ramp = {
	.name = "temp/ramp",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Temperature relative to a velocity that varies linearly",
	.doc = "As compute temp for u, the velocity less that of a flow of which one component is vlo for "
	       "coordinates up to lo, vhi from hi on, and varies linearly between them, such as the shear "
	       "flow between two walls. For a flow that is not known see compute temp/profile and "
	       "temp/granular.",
	.example = "compute heat gas temp/ramp vx 0 0.5 z 0 0.02 units box",
	.args = args,
	.state_size = sizeof(struct temp_ramp),
	.init = init,
	.values = values,
	.modify = ts_freedom_modify,
};
