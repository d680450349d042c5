/* Compute: reduces a value of each particle to one number per chunk. */
#include "average/chunk_user.h"
#include "core/ref_list.h"
#include "math/reduction.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { ZERO, SKIP };
static const char *const empties[] = { [ZERO] = "zero", [SKIP] = "skip", NULL };

struct state {
	struct ts_chunk_user user;
	int mode, empty;
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

/* Whether the chunk has a row: with `empty skip` if it has particles of the group. */
static bool has_row(const struct ts_instance *self, const struct ts_chunks *chunks, size_t c)
{
	const struct state *s = self->state;

	if (s->empty == ZERO)
		return true;
	for (size_t k = chunks->first[c]; k < chunks->first[c + 1]; k++)
		if (ts_in_group(s->user.sim->particles, (size_t)chunks->member[k], self->group))
			return true;
	return false;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	struct ts_chunks *chunks;
	size_t rows = 0;

	(void)sim;
	TS_TRY(ts_chunk_user_assign(self, &chunks));
	for (size_t c = 1; c <= chunks->n; c++)
		rows += has_row(self, chunks, c);
	TS_TRY(ts_table_resize(out, rows, s->input.n));
	for (size_t k = 0; k < s->input.n; k++) {
		TS_TRY(ts_ref_input_eval(s->user.sim, &s->input.item[k], &s->each));
		rows = 0;
		for (size_t c = 1; c <= chunks->n; c++)
			if (has_row(self, chunks, c))
				out->data[rows++ * s->input.n + k] =
					reduce_chunk(self, chunks, c, s->each.data);
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
	{ "values", "", "of a single input, for each chunk that has a row", TS_VECTOR, 0, NULL, eval },
	{ "table", "", "of several inputs: a row for each chunk, or for each that is not empty", TS_ARRAY, 0,
	  NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_CHUNK_USER_ARG(struct state),
	TS_ENUM("mode", struct state, mode, ts_reduction_names, .flags = TS_POSITIONAL,
		.help = "reduction of the values"),
	TS_LIST("values", struct state, words,
		.help = "x, vx, radius ..., c_ID, c_ID[k], c_ID[*], f_ID, f_ID[k] or v_name"),
	TS_ENUM("empty", struct state, empty, empties, .fallback = "zero",
		.help = "chunks without particles of the group: 0, or no row"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_reduce_chunk)
const struct ts_style ts_compute_reduce_chunk = {
	.name = "reduce/chunk",
	.kind = TS_KIND_COMPUTE,
	.family = TS_FAMILY_CHUNK_USER,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Sum, minimum, maximum, mean or deviation of per-particle values over each chunk",
	.doc = "As compute reduce, over the particles of the group in each chunk of compute chunk/atom: "
	       "their sum, minimum (min), maximum (max), mean (ave), standard deviation (std) and so on. "
	       "c_ID[i] is the result for chunk i; with several inputs c_ID[i][k] is that of input k. Sums "
	       "are exact, rounded once, and do not depend on the order. A chunk without particles of the "
	       "group has 0.\n\n"
	       "With `empty skip` such a chunk has no row, and c_ID[i] is the result for the i-th chunk that "
	       "is not empty: ave(c_ID), min(c_ID), sort(c_ID) in variables then count no zeros that stand "
	       "for nothing. An input such as a coordinate tells which row is whose; length(c_ID) is the "
	       "number of rows. It may change from step to step, which `mode vector` of fix ave/time and "
	       "compute chunk/spread/atom refuse; thermo_style prints a variable.",
	.example = "compute heap all cluster/atom 0.01\n"
		   "compute heaps all chunk/atom c_heap compress yes\n"
		   "compute mass all reduce/chunk heaps sum mass\n"
		   "compute top all reduce/chunk heaps max z vz\n"
		   "compute rough all reduce/chunk columns max z empty skip\n"
		   "variable height equal ave(c_rough)",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.gives = gives,
	.init = init,
	.fini = fini,
};
