/* Fix vector: a number at intervals, collected into a growing vector. */
#include "core/sim.h"

#include <string.h>

#include "base/banned.h"

struct state {
	int64_t every, start;
	const char *name;
	struct ts_ref ref;
	double *sample;
	size_t n, capacity;
	int64_t last; /* step of the last sample, if n > 0 */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	return ts_ref_resolve(sim, s->name, &self->where, &s->ref);
}

static enum ts_status collect(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	int64_t step = sim->clock.step;

	if (step % s->every != 0 || step < s->start || (s->n && step == s->last))
		return TS_OK;
	if (TS_GROW(s->sample, s->capacity, s->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(ts_ref_scalar(sim, &s->ref, &self->where, &s->sample[s->n]));
	s->n++;
	s->last = step;
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim,
			      struct ts_archive *archive)
{
	struct state *s = self->state;

	(void)sim;
	return ts_archive_array(archive, "sample", TS_SAVED_F64, (void **)&s->sample, &s->capacity,
				&s->n);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	TS_TRY(ts_table_resize(out, s->n, 1));
	if (s->n)
		memcpy(out->data, s->sample, s->n * sizeof *s->sample);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_free(s->sample);
}

static const struct ts_arg args[] = {
	TS_INT("every", struct state, every, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_POSITIVE,
	       .help = "steps between samples"),
	TS_REF("value", struct state, name, .flags = TS_POSITIONAL | TS_STATEFUL,
	       .help = "c_ID, c_ID[k], f_ID, f_ID[k], v_NAME or a thermo keyword"),
	TS_INT("start", struct state, start, .flags = TS_STATEFUL, .fallback = "0",
	       .help = "no samples before this step"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ .name = "samples",
	  .unit = "",
	  .help = "all samples so far, the first of them [1]",
	  .shape = TS_VECTOR,
	  .eval = eval },
	{ .name = NULL },
};

static const struct ts_saved saved[] = { TS_SAVE_I64(struct state, last), TS_SAVED_ROWS_END };

TS_STYLE(fix, ts_style, ts_fix_vector)
const struct ts_style ts_fix_vector = {
	.name = "vector",
	.kind = TS_KIND_FIX,
	.summary = "Collects a number at intervals into a growing vector",
	.doc = "Samples are taken at the start of a run and at the end of each step that is a multiple of N,\n"
	       "once per step. The vector is saved in restart files.",
	.example = "fix heights all vector 100 f_bit[1]",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.hook = {
		[TS_STAGE_SETUP] = collect,
		[TS_STAGE_END_OF_STEP] = collect,
	},
	.fini = fini,
};
