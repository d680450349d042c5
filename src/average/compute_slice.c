/* Compute: every n-th element of vectors. */
#include "core/ref_list.h"
#include "core/sim.h"

#include "base/banned.h"

struct state {
	int64_t start, stop, skip;
	struct ts_words words;
	struct ts_ref_list input;
	struct ts_table each;
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->sim = sim;
	if (s->start > s->stop)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "compute slice: Nstart (%lld) is larger than Nstop (%lld)",
			       (long long)s->start, (long long)s->stop);
	return ts_ref_list_init(sim, "compute slice", &self->arena, s->words, TS_WANT(VECTOR), &s->input);
}

static enum ts_status eval_array(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	size_t n = (size_t)((s->stop - s->start) / s->skip + 1);

	(void)sim;
	TS_TRY(ts_table_resize(out, n, s->input.n));
	for (size_t k = 0; k < s->input.n; k++) {
		const struct ts_ref_input *input = &s->input.item[k];
		size_t length;

		TS_TRY(ts_ref_input_eval(s->sim, input, &s->each));
		length = s->each.rows * s->each.columns;
		if ((int64_t)length < s->stop)
			return ts_fail(&s->sim->error, TS_RANGE, &input->where,
				       "compute slice: '%s' has %zu elements, Nstop is %lld", input->name,
				       length, (long long)s->stop);
		for (size_t i = 0; i < n; i++)
			out->data[i * s->input.n + k] =
				s->each.data[(size_t)(s->start - 1 + (int64_t)i * s->skip)];
	}
	return TS_OK;
}

/* The slice of the first input. */
static enum ts_status eval_vector(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	TS_TRY(eval_array(self, sim, out));
	for (size_t i = 1; i < out->rows; i++)
		out->data[i] = out->data[i * out->columns];
	out->columns = out->rows;
	out->rows = 1;
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_table_release(&s->each);
	ts_ref_list_release(&s->input);
}

static const struct ts_value values[] = {
	{ "first", "", "the slice of the first input", TS_VECTOR, 0, NULL, eval_vector },
	{ "all", "", "a column for each input", TS_ARRAY, 0, NULL, eval_array },
	{ .name = NULL },
};

#define INDEX(name, field, text)                                                                          \
	TS_INT(name, struct state, field, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1, .hi = 1e9, \
	       .help = text)
static const struct ts_arg args[] = {
	INDEX("Nstart", start, "first element"),
	INDEX("Nstop", stop, "last element"),
	INDEX("Nskip", skip, "index difference of successive elements"),
	TS_REST("inputs", struct state, words, .help = "vectors: c_ID, f_ID, v_NAME, or columns c_ID[k]"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_slice)
const struct ts_style ts_compute_slice = {
	.name = "slice",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Every n-th element of vectors",
	.doc = "Extracts the elements Nstart, Nstart + Nskip ... up to Nstop of each input vector. c_ID[i] "
	       "is element i of the slice of the first input, c_ID[i][j] element i of that of input j.",
	.example = "compute tail all slice 50 100 5 c_g[2]",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
	.fini = fini,
};
