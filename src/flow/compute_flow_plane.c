/* Compute: velocity, pressure ... of the fluid in a plane. */
#include "base/axes.h"
#include "flow/flow.h"
#include "flow/flow_sampling.h"
#include "region/region.h"

#include "base/banned.h"

struct state {
	struct ts_flow_sampler sampler;
	int axis;
	double at;
};

/* The axes along the plane, in order. */
static void in_plane_axes(const struct state *s, int *b, int *c)
{
	*b = s->axis == 0 ? 1 : 0;
	*c = s->axis == 2 ? 1 : 2;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	struct ts_fluid *fluid;
	double x[3];

	TS_TRY(ts_flow_sampler_init(self, sim));
	TS_TRY(ts_flow_require_fluid(sim, "compute flow/plane", &self->where, &fluid));
	for (int d = 0; d < 3; d++)
		x[d] = d == s->axis ? s->at : fluid->grid.centre[d][0];
	return ts_flow_sampler_inside(self, sim, x, &self->where);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	const struct ts_grid *grid;
	struct ts_fluid *fluid;
	double x[3], *row;
	int b, c;

	(void)sim;
	in_plane_axes(s, &b, &c);
	TS_TRY(ts_flow_require_fluid(s->sampler.sim, "compute flow/plane", &self->where, &fluid));
	grid = &fluid->grid;
	TS_TRY(ts_flow_sampler_begin(self, (size_t)grid->n[b] * (size_t)grid->n[c], out, &fluid));
	x[s->axis] = s->at;
	row = out->data;
	for (int k = 0; k < grid->n[c]; k++)
		for (int j = 0; j < grid->n[b]; j++, row += out->columns) {
			x[b] = grid->centre[b][j];
			x[c] = grid->centre[c][k];
			ts_flow_sample(&s->sampler, fluid, x, 0, row);
		}
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "cells", "", "one row for each cell, one column for each value", TS_ARRAY, 0, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_ENUM("axis", struct state, axis, ts_axis_names, .flags = TS_POSITIONAL,
		.help = "normal of the plane"),
	TS_REAL("at", struct state, at, .flags = TS_POSITIONAL, .unit = "length",
		.help = "its coordinate along that axis"),
	TS_FLOW_SAMPLE_ARGS(struct state),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_flow_plane)
const struct ts_style ts_compute_flow_plane = {
	.name = "flow/plane",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Velocity, pressure and other fields of the fluid in a plane",
	.doc = "One row for each cell of the grid in the plane, at the centre of the cell seen along the\n"
	       "axis. Of the two other axes the first one varies fastest.\n\n" TS_FLOW_SAMPLE_DOC,
	.example = "compute cut all flow/plane z 0.5 values x y vx vy p wz\n"
		   "fix out all ave/time 1000 1 1000 c_cut[*] mode vector file cut.txt",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
