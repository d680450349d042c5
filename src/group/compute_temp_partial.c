/* Compute temp/partial: temperature of the motion along some of the axes. */
#include "group/temperature.h"

#include "base/banned.h"

struct temp_partial {
	struct ts_freedom freedom; /* first: see group/temperature.h */
	int64_t along[3];
};

static void along_axes(const struct tsim *sim, size_t i, const void *context, double u[3])
{
	const struct temp_partial *c = context;

	for (int d = 0; d < 3; d++)
		u[d] = c->along[d] ? sim->particles->v[i][d] : 0;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct temp_partial *c = self->state;

	if (sim->dimension == 2 && c->along[2])
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "compute temp/partial: in two dimensions there is no motion along z: expected "
			       "zflag 0");
	return TS_OK;
}

/* Each axis has the same part of the degrees of freedom. */
static enum ts_status eval_temperature(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct temp_partial *c = self->state;
	const double axes = (double)(c->along[0] + c->along[1] + c->along[2]);
	double sum[7];

	ts_temperature_tensor_in(sim, self->group, along_axes, c, sum);
	out->data[0] = axes > 0 ? ts_temperature(sim, sum, &c->freedom) * sim->dimension / axes : 0;
	return TS_OK;
}

static enum ts_status eval_tensor(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double sum[7];

	ts_temperature_tensor_in(sim, self->group, along_axes, self->state, sum);
	return ts_temperature_write_tensor(sum, out);
}

static const struct ts_arg args[] = {
	TS_INT("xflag", struct temp_partial, along[0], .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0,
	       .hi = 1, .help = "1: velocities along x count; 0: they do not"),
	TS_INT("yflag", struct temp_partial, along[1], .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0,
	       .hi = 1, .help = "the same for y"),
	TS_INT("zflag", struct temp_partial, along[2], .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0,
	       .hi = 1, .help = "the same for z"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "temperature", "temperature", "temperature of the motion along these axes", TS_SCALAR, 1, NULL,
	  eval_temperature },
	{ "tensor", "energy", "kinetic tensor: sum of m v_a v_b, 0 for other axes", TS_VECTOR, 6,
	  ts_tensor_names, eval_tensor },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_temp_partial)
const struct ts_style ts_compute_temp_partial = {
	.name = "temp/partial",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Temperature of the motion along some of the axes",
	.doc = "As compute temp for the components of the velocity along n of the D axes, for instance those "
	       "across a flow: T = sum m v^2 / (n (N - 1) k_B). `compute_modify ID extra M` replaces the "
	       "degrees of "
	       "freedom by n N - M n/D.",
	.example = "compute across all temp/partial 0 1 1",
	.args = args,
	.state_size = sizeof(struct temp_partial),
	.init = init,
	.values = values,
	.modify = ts_freedom_modify,
};
