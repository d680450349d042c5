/* Compute: reduces a value of each particle to one number per chunk. */
#include "average/chunk_user.h"
#include "core/ref_list.h"
#include "math/reduction.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	struct ts_chunk_user user;
	int mode;
	struct ts_words words;
	struct ts_ref_list input;
	struct ts_table each;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_chunk_user_init(self, sim));
	return ts_ref_list_init(sim, "compute reduce/chunk", &self->arena, s->words, TS_WANT(PERATOM),
				&s->input);
}

/* One input is a vector of chunks, several are an array. */
static bool gives(const struct ts_instance *self, const struct ts_value *value)
{
	const struct state *s = self->state;
	size_t n = s->input.item ? s->input.n : s->words.n;

	return value->shape == (n == 1 ? TS_VECTOR : TS_ARRAY);
}

static double reduce_chunk(const struct ts_instance *self, const struct ts_chunks *chunks, size_t c,
			   const double *value)
{
	const struct state *s = self->state;
	struct ts_reduction tally = ts_reduction_start();

	for (size_t k = chunks->first[c]; k < chunks->first[c + 1]; k++) {
		size_t i = (size_t)chunks->member[k];

		if (ts_in_group(s->user.sim->particles, i, self->group))
			ts_reduction_add(&tally, (enum ts_reduction_mode)s->mode, value[i]);
	}
	return ts_reduction_value(&tally, (enum ts_reduction_mode)s->mode);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	struct ts_chunks *chunks;

	(void)sim;
	TS_TRY(ts_chunk_user_assign(self, &chunks));
	TS_TRY(ts_table_resize(out, chunks->n, s->input.n));
	for (size_t k = 0; k < s->input.n; k++) {
		TS_TRY(ts_ref_input_eval(s->user.sim, &s->input.item[k], &s->each));
		for (size_t c = 1; c <= chunks->n; c++)
			out->data[(c - 1) * s->input.n + k] = reduce_chunk(self, chunks, c, s->each.data);
	}
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_chunk_user_fini(self);
	ts_ref_list_release(&s->input);
	ts_table_release(&s->each);
}

static const struct ts_value values[] = {
	{ "values", "", "of a single input, for each chunk", TS_VECTOR, 0, NULL, eval },
	{ "table", "", "of several inputs: a row for each chunk", TS_ARRAY, 0, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_CHUNK_USER_ARG(struct state),
	TS_ENUM("mode", struct state, mode, ts_reduction_names, .flags = TS_POSITIONAL,
		.help = "reduction of the values"),
	TS_LIST("values", struct state, words,
		.help = "x, vx, radius ..., c_ID, c_ID[k], c_ID[*], f_ID, f_ID[k] or v_name"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_reduce_chunk)
const struct ts_style ts_compute_reduce_chunk = {
	.name = "reduce/chunk",
	.kind = TS_KIND_COMPUTE,
	.summary = "Sum, minimum, maximum or mean of per-particle values over each chunk",
	.doc = "As compute reduce, over the particles of the group in each chunk of compute chunk/atom: "
	       "their sum, minimum (min), maximum (max), mean (ave) and so on. c_ID[i] is the result for "
	       "chunk i; with several inputs c_ID[i][k] is that of input k. Sums are exact, rounded once, "
	       "and do not depend on the order. A chunk without particles of the group has 0.",
	.example = "compute heap all cluster/atom 0.01\n"
		   "compute heaps all chunk/atom c_heap compress yes\n"
		   "compute mass all reduce/chunk heaps sum mass\n"
		   "compute top all reduce/chunk heaps max z vz",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.gives = gives,
	.init = init,
	.fini = fini,
};
