/* Fix vector: collects global values every N steps into a growing vector or array. */
#include "core/ref_list.h"
#include "core/sim.h"

#include <string.h>

#include "base/banned.h"

struct state {
	int64_t every, start;
	struct ts_words words;
	struct ts_ref_list input;
	double *sample;	    /* [samples][inputs] */
	size_t n, capacity; /* in numbers: samples times inputs */
	int64_t last;	    /* step of the last sample, if n > 0 */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	return ts_ref_list_init(sim, "fix vector", &self->arena, s->words, TS_WANT(SCALAR), &s->input);
}

static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return sim->clock.step % s->every == 0 && sim->clock.step >= s->start;
}

static enum ts_status collect_sample(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	int64_t step = sim->clock.step;

	if (!due(self, sim) || (s->n && step == s->last))
		return TS_OK;
	if (TS_GROW(s->sample, s->capacity, s->n + s->input.n) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(ts_ref_list_scalars(sim, &s->input, &s->sample[s->n]));
	s->n += s->input.n;
	s->last = step;
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive)
{
	struct state *s = self->state;

	TS_TRY(ts_archive_array(archive, "sample", TS_SAVED_F64, (void **)&s->sample, &s->capacity, &s->n));
	if (s->n % s->input.n == 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix vector %s: the restart file holds samples of another number of values", self->id);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	TS_TRY(ts_table_resize(out, s->n / s->input.n, s->input.n));
	if (s->n)
		memcpy(out->data, s->sample, s->n * sizeof *s->sample);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_free(s->sample);
	ts_ref_list_release(&s->input);
}

static bool gives(const struct ts_instance *self, const struct ts_value *value)
{
	bool several = ((const struct state *)self->state)->input.n > 1;

	return value->shape == (several ? TS_ARRAY : TS_VECTOR);
}

static const struct ts_arg args[] = {
	TS_INT("every", struct state, every, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_POSITIVE,
	       .help = "steps between samples"),
	TS_LIST_STATEFUL("values", struct state, words,
			 .help = "c_ID, c_ID[k], c_ID[*], f_ID, f_ID[k], v_NAME or thermo keywords"),
	TS_INT("start", struct state, start, .flags = TS_STATEFUL, .fallback = "0",
	       .help = "no samples before this step"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ .name = "samples",
	  .unit = "",
	  .help = "all samples so far, [1] being the first",
	  .shape = TS_VECTOR,
	  .eval = eval },
	{ .name = "series",
	  .unit = "",
	  .help = "for several values all samples so far: f_ID[i][j] is sample i of value j, f_ID[j] all "
		  "samples of value j",
	  .shape = TS_ARRAY,
	  .eval = eval },
	{ .name = NULL },
};

static const struct ts_saved saved[] = { TS_SAVE_I64(struct state, last), TS_SAVED_ROWS_END };

TS_STYLE(fix, ts_style, ts_fix_vector)
const struct ts_style ts_fix_vector = {
	.name = "vector",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = due,
	.summary = "Collects global values every N steps into a growing vector or array",
	.doc = "Takes samples at the start of a run and at the end of each step that is a multiple of N, at most once per step. A single value makes a vector, several values an array with a column for each: slope(f_ID[2]) is the slope of the second value over the sample number. All samples are saved in restart files.",
	.example = "fix heights all vector 100 f_bit[1]\n"
		   "fix path all vector 10 time c_centre[*]",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.gives = gives,
	.init = init,
	.hook = {
		[TS_STAGE_SETUP] = collect_sample,
		[TS_STAGE_END_OF_STEP] = collect_sample,
	},
	.fini = fini,
};
