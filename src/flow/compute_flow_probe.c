/* Compute: velocity, pressure ... of the fluid at points. */
#include "flow/flow_sampling.h"

#include "base/banned.h"

struct state {
	struct ts_flow_sampler sampler;
	struct ts_words words;
	double *point; /* 3 n, in the arena */
};

static enum ts_status read_points(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->words.n % 3)
		return ts_fail(&sim->error, TS_SYNTAX, &s->words.word[s->words.n - 1].place,
			       "compute flow/probe: %zu numbers, expected three for each point", s->words.n);
	if (!s->point)
		s->point = ts_arena_alloc(&self->arena, s->words.n, sizeof *s->point);
	if (!s->point)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < s->words.n; k++)
		if (!ts_parse_real(s->words.word[k].text, &s->point[k]))
			return ts_fail(&sim->error, TS_SYNTAX, &s->words.word[k].place,
				       "compute flow/probe: '%s', expected a coordinate",
				       s->words.word[k].text);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_flow_sampler_init(self, sim));
	TS_TRY(read_points(self, sim));
	for (size_t k = 0; k < s->words.n; k += 3)
		TS_TRY(ts_flow_sampler_inside(self, sim, s->point + k, &s->words.word[k].place));
	return TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t n = s->words.n / 3, columns = s->sampler.list.n;
	struct ts_fluid *fluid;

	(void)sim;
	TS_TRY(ts_flow_sampler_begin(self, n, out, &fluid));
	for (size_t k = 0; k < n; k++)
		ts_flow_sample(&s->sampler, fluid, s->point + 3 * k, 0, out->data + k * columns);
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

static const struct ts_arg args[] = {
	TS_LIST("points", struct state, words, .help = "x y z of one or more points"),
	TS_FLOW_SAMPLE_ARGS(struct state),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_flow_probe)
const struct ts_style ts_compute_flow_probe = {
	.name = "flow/probe",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Velocity, pressure and other fields of the fluid at points",
	.doc = "One row for each point: c_ID[i][j] is the j-th value at the i-th point, c_ID[k] the k-th\n"
	       "value at the first point.\n\n" TS_FLOW_SAMPLE_DOC,
	.example = "compute wake all flow/probe 0.5 0.25 0 0.8 0.25 0 values vx vy p",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
