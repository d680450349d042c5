/* Fix ave/atom: time averages of per-particle values. */
#include "average/average.h"
#include "core/ref_list.h"
#include "particle/columns.h"

#include "particle/particles.h"

#include "base/banned.h"

/* Sums and results are a column of the particles, so that they follow them: the sums of all values, then
 * the averages. */
struct state {
	struct ts_average average; /* only its counting of samples is used */
	struct ts_words words;
	struct ts_ref_list input;
	struct ts_table one;
	size_t column;
	bool cleared;
};

static double *sums_of(const struct tsim *sim, const struct state *s, size_t i)
{
	const struct ts_column *c = &sim->particles->column[s->column];

	return (double *)c->data + i * c->width;
}

static enum ts_status add_sum_column(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	size_t width = 2 * s->input.n;
	struct ts_str name = { 0 };
	enum ts_status status;

	ts_str_addf(&name, "fix ave/atom %s %zu", self->id, width);
	status = name.failed
			 ? ts_nomem(&sim->error)
			 : ts_particles_add_column(sim, ts_str_text(&name), width, TS_COL_RESULT, &s->column);
	ts_str_release(&name);
	/* the column may still exist from a deleted fix of the same id */
	for (size_t i = 0; status == TS_OK && !s->cleared && i < sim->particles->n; i++)
		for (size_t k = 0; k < width; k++)
			sums_of(sim, s, i)[k] = 0;
	s->cleared = status == TS_OK;
	return status;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_average_init(self, sim, &s->average));
	TS_TRY(ts_ref_list_init(sim, "fix ave/atom", &self->arena, s->words, TS_WANT(PERATOM), &s->input));
	return add_sum_column(self, sim);
}

static enum ts_status sample(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	size_t m = s->input.n;
	bool first = s->average.samples == 0, last;

	if (!ts_average_due(&s->average, sim))
		return TS_OK;
	last = ts_average_sampled(&s->average, sim);
	for (size_t k = 0; k < m; k++) {
		TS_TRY(ts_ref_input_eval(sim, &s->input.item[k], &s->one));
		for (size_t i = 0; i < p->n; i++) {
			double *sum = sums_of(sim, s, i) + k;

			*sum = (first ? 0 : *sum) + (ts_in_group(p, i, self->group) ? s->one.data[i] : 0);
			if (last)
				sum[m] = *sum / (double)s->average.repeat;
		}
	}
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	return ts_particles_archive_column(a, sim, "sums", ((struct state *)self->state)->column);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t n = sim->particles->n, m = s->input.n;

	TS_TRY(ts_table_resize(out, n, m));
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < m; k++)
			out->data[i * m + k] = sums_of(sim, s, i)[m + k];
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_table_release(&s->one);
	ts_ref_list_release(&s->input);
}

static size_t width(const struct ts_instance *self)
{
	return ((const struct state *)self->state)->input.n;
}

static const struct ts_value values[] = {
	{ .name = "averages",
	  .unit = "",
	  .help = "the average of each value; 0 outside the group",
	  .shape = TS_PERATOM,
	  .eval = eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_AVERAGE_STEPS(struct state, average),
	{ .name = "values",
	  .type = TS_ARG_REST,
	  .flags = TS_POSITIONAL | TS_STATEFUL,
	  .offset = TS_FIELD(struct state, words, struct ts_words *),
	  .help = "x, vx, fx ..., c_ID, c_ID[k], c_ID[*], f_ID, f_ID[k] or v_name" },
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_AVERAGE_SAVED(struct state, average), TS_SAVED_ROWS_END };

TS_STYLE(fix, ts_style, ts_fix_ave_atom)
const struct ts_style ts_fix_ave_atom = {
	.name = "ave/atom",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = ts_average_waits,
	.summary = "Time averages of per-particle values",
	.doc = "Calculates every Nfreq steps, for each particle of the group, the mean of Nrepeat samples taken Nevery steps apart, the last at that step. f_ID[k] is the average of value k, f_ID that of a single value; 0 before the first average. For a particle that is inserted in the middle of an average, the missed samples count as 0. Averages in progress are saved in restart files.",
	.example = "fix slow all ave/atom 10 100 1000 vx vy vz\ndump d all custom 1000 post/slow*.txt id f_slow[1]",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.width = width,
	.init = init,
	.hook = {
		[TS_STAGE_SETUP] = sample,
		[TS_STAGE_END_OF_STEP] = sample,
	},
	.fini = fini,
};
