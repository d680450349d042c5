/* Compute: velocity, pressure ... of the fluid along a line. */
#include "base/axes.h"
#include "flow/flow.h"
#include "flow/flow_sampling.h"
#include "math/vec3.h"
#include "region/region.h"

#include "base/banned.h"

enum { BETWEEN, CELLS };

struct state {
	struct ts_flow_sampler sampler;
	int mode;
	double from[3], to[3];
	int64_t n;
	int axis;
	double other[2]; /* coordinates of the axis-parallel line, in order */
};

/* The k-th point of n. */
static void point_of(const struct state *s, const struct ts_grid *grid, size_t k, double x[3])
{
	for (int d = 0, next = 0; d < 3; d++) {
		if (s->mode == CELLS)
			x[d] = d == s->axis ? grid->centre[d][k] : s->other[next++];
		else if (k + 1 == (size_t)s->n)
			x[d] = s->to[d];
		else
			x[d] = s->from[d] + (s->to[d] - s->from[d]) * (double)k / (double)(s->n - 1);
	}
}

static size_t number_of_points(const struct state *s, const struct ts_grid *grid)
{
	return (size_t)(s->mode == CELLS ? grid->n[s->axis] : s->n);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	struct ts_fluid *fluid;
	double x[3];

	TS_TRY(ts_flow_sampler_init(self, sim));
	TS_TRY(ts_flow_require_fluid(sim, "compute flow/line", &self->where, &fluid));
	for (int end = 0; end < 2; end++) {
		point_of(s, &fluid->grid, end ? number_of_points(s, &fluid->grid) - 1 : 0, x);
		TS_TRY(ts_flow_sampler_inside(self, sim, x, &self->where));
	}
	return TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	struct ts_fluid *fluid;
	double first[3], x[3];
	size_t n;

	(void)sim;
	TS_TRY(ts_flow_require_fluid(s->sampler.sim, "compute flow/line", &self->where, &fluid));
	n = number_of_points(s, &fluid->grid);
	TS_TRY(ts_flow_sampler_begin(self, n, out, &fluid));
	point_of(s, &fluid->grid, 0, first);
	for (size_t k = 0; k < n; k++) {
		double r[3];

		point_of(s, &fluid->grid, k, x);
		ts_sub(x, first, r);
		ts_flow_sample(&s->sampler, fluid, x, ts_norm(r), out->data + k * out->columns);
	}
	return TS_OK;
}

static enum ts_status eval_first(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	return ts_flow_sampler_first_row(self, sim, out, eval);
}

static const struct ts_value values[] = {
	{ "first", "", "the values at the first point", TS_VECTOR, 0, NULL, eval_first },
	{ "points", "", "one row for each point, one column for each value", TS_ARRAY, 0, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg between[] = {
	TS_VEC3("from", struct state, from, .flags = TS_POSITIONAL, .unit = "length", .help = "first point"),
	TS_VEC3("to", struct state, to, .flags = TS_POSITIONAL, .unit = "length", .help = "last point"),
	TS_INT("N", struct state, n, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 2, .hi = 1e7,
	       .help = "number of points, both ends counted"),
	TS_ARGS_END,
};

static const struct ts_arg cells[] = {
	TS_ENUM("axis", struct state, axis, ts_axis_names, .flags = TS_POSITIONAL,
		.help = "direction of the line"),
	TS_REAL("first", struct state, other[0], .flags = TS_POSITIONAL, .unit = "length",
		.help = "the first of the two other coordinates, in the order x, y, z"),
	TS_REAL("second", struct state, other[1], .flags = TS_POSITIONAL, .unit = "length",
		.help = "the second of the other coordinates"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[BETWEEN] = { "between", "points at equal distances", between },
	[CELLS] = { "cells", "the centres of all cells along an axis", cells },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_MODE("mode", struct state, mode, modes, .help = "which points"),
	TS_FLOW_SAMPLE_ARGS(struct state),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_flow_line)
const struct ts_style ts_compute_flow_line = {
	.name = "flow/line",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Velocity, pressure and other fields of the fluid along a line",
	.doc = "One row for each point of the line: N equidistant points between two positions, or the\n"
	       "centres of the cells along an axis. c_ID[i][j] is the j-th value at the i-th point,\n"
	       "c_ID[j] the list of the j-th value at all points.\n\n" TS_FLOW_SAMPLE_DOC,
	.example =
		"compute profile all flow/line cells y 0.5 0.5 values y vx\n"
		"compute axis all flow/line between 0 0.5 0.5 1 0.5 0.5 129 values s vy interpolation cubic\n"
		"fix out all ave/time 100 1 100 c_profile[*] mode vector file profile.txt",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
