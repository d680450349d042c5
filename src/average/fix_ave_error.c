/* Fix ave/error: time averages with standard errors by blocks. */
#include "average/block_error.h"
#include "core/ref_list.h"
#include "core/sim.h"

#include "base/banned.h"

enum { SCALAR, VECTOR };

struct state {
	int64_t every, start;
	struct ts_words words;
	int mode;
	struct ts_ref_list input;
	struct ts_table sample;
	struct ts_blocks blocks;
	int64_t started, last; /* last: step of the last sample, if started */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_ref_list_init(sim, "fix ave/error", &self->arena, s->words,
				s->mode == VECTOR ? TS_WANT(VECTOR) | TS_WANT_COLUMNS : TS_WANT(SCALAR),
				&s->input));
	if (s->mode == VECTOR && s->input.n > 1)
		return ts_fail(&sim->error, TS_SYNTAX, &s->input.item[1].where,
			       "fix ave/error: mode vector takes one vector, found %zu values; use a fix for "
			       "each",
			       s->input.n);
	if (s->blocks.most % 2)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix ave/error: blocks is %lld, expected an even number",
			       (long long)s->blocks.most);
	return TS_OK;
}

/* The numbers of a sample, into s->sample. */
static enum ts_status evaluate(struct state *s, struct tsim *sim, size_t *n)
{
	if (s->mode == VECTOR) {
		TS_TRY(ts_ref_list_table(sim, &s->input, &s->sample));
		*n = s->sample.rows;
		return TS_OK;
	}
	*n = s->input.n;
	if (ts_table_resize(&s->sample, s->input.n, 1) != TS_OK)
		return ts_nomem(&sim->error);
	return ts_ref_list_scalars(sim, &s->input, s->sample.data);
}

static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return sim->clock.step % s->every == 0 && sim->clock.step >= s->start;
}

static enum ts_status take_sample(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	int64_t step = sim->clock.step;
	size_t n;

	if (!due(self, sim) || (s->started && step == s->last))
		return TS_OK;
	TS_TRY(evaluate(s, sim, &n));
	if (s->started && n != s->blocks.n)
		return ts_fail(&sim->error, TS_STATE, &s->input.item[0].where,
			       "fix ave/error %s: '%s' has %zu elements, expected %zu as in the samples "
			       "before",
			       self->id, s->input.item[0].name, n, s->blocks.n);
	if (ts_blocks_add(&s->blocks, s->sample.data, n) != TS_OK)
		return ts_nomem(&sim->error);
	s->started = 1;
	s->last = step;
	return TS_OK;
}

/* Before the first sample there are rows already, of NaN. */
static enum ts_status set_up(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	size_t n;

	if (!s->started) {
		TS_TRY(evaluate(s, sim, &n));
		if (ts_blocks_resize(&s->blocks, n) != TS_OK)
			return ts_nomem(&sim->error);
	}
	return take_sample(self, sim);
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;

	TS_TRY(ts_blocks_archive(a, &s->blocks));
	if (!ts_blocks_valid(&s->blocks) || (s->mode == SCALAR && s->blocks.n && s->blocks.n != s->input.n))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix ave/error %s: the restart file holds averages of another number of "
			       "values",
			       self->id);
	return TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	TS_TRY(ts_table_resize(out, s->blocks.n, TS_BLOCKS_COLUMNS));
	for (size_t k = 0; k < s->blocks.n; k++)
		ts_blocks_result(&s->blocks, k, out->data + k * TS_BLOCKS_COLUMNS);
	return TS_OK;
}

static enum ts_status eval_samples(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	out->data[0] = (double)ts_blocks_samples(&((const struct state *)self->state)->blocks);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_blocks_release(&s->blocks);
	ts_table_release(&s->sample);
	ts_ref_list_release(&s->input);
}

static const char *const modes[] = { [SCALAR] = "scalar", [VECTOR] = "vector", NULL };
static const char *const names[] = { "mean", "error", "trend", "correlation", NULL };

static const struct ts_arg args[] = {
	TS_INT("Nevery", struct state, every, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN,
	       .lo = 1, .hi = 1e15, .help = "steps between samples"),
	TS_LIST_STATEFUL("values", struct state, words,
			 .help = "c_ID, c_ID[k], c_ID[*], f_ID, f_ID[k], v_NAME or thermo keywords"),
	TS_ENUM("mode", struct state, mode, modes, .flags = TS_STATEFUL, .fallback = "scalar",
		.help = "whether the values are scalars, or one vector"),
	TS_INT("blocks", struct state, blocks.most, .flags = TS_STATEFUL, .range = TS_WITHIN, .lo = 4,
	       .hi = 1e4, .fallback = "32", .help = "largest number of blocks, even"),
	TS_INT("start", struct state, start, .flags = TS_STATEFUL, .range = TS_WITHIN, .lo = 0, .hi = 1e15,
	       .fallback = "0", .help = "no samples before this step"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ .name = "samples",
	  .unit = "",
	  .help = "number of samples so far",
	  .shape = TS_SCALAR,
	  .columns = 1,
	  .eval = eval_samples },
	{ .name = "averages",
	  .unit = "",
	  .help = "a row for each value, or element of the vector",
	  .shape = TS_ARRAY,
	  .columns = TS_BLOCKS_COLUMNS,
	  .column_names = names,
	  .eval = eval },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct state, started),	  TS_SAVE_I64(struct state, last),
	TS_SAVE_I64(struct state, blocks.size),	  TS_SAVE_I64(struct state, blocks.filled),
	TS_SAVE_I64(struct state, blocks.inside), TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_ave_error)
const struct ts_style ts_fix_ave_error = {
	.name = "ave/error",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = due,
	.summary = "Time averages with standard errors",
	.doc = "Takes samples at the start of a run and at the end of each step that is a multiple of Nevery, and averages each value over all of them. f_ID[i][1] is the mean of value i (with `mode vector` of element i), f_ID[i][2] its standard error.\n\n"
	       "Successive samples are correlated, so that their scatter alone gives too small an error. The samples are therefore averaged in successive blocks of equal length, whose number grows to `blocks`; then pairs of blocks are joined and their length doubles. With m = blocks/2 to blocks block means b_k of mean b the standard error is\n\n"
	       "    sqrt(sum (b_k - b)^2 / (m (m - 1)))\n\n"
	       "It is valid if the blocks are much longer than the correlation time of the values, which f_ID[i][4] shows: the correlation coefficient of successive block means, near 0 (within about 2/sqrt(m)) if they are independent. The error itself is uncertain by the fraction 1/sqrt(2 m).\n\n"
	       "f_ID[i][3] tests whether the state is steady: the mean of the second half of the blocks minus that of the first, divided by the standard error of this difference. Of steady data it is within -2 and 2 in 19 cases of 20; beyond 3 the values drift. Errors, trends and correlations are NaN before there are two, four, four blocks. To leave out the initial transient, define the fix after a first run, or use `start`; also for averages of other fixes, which are 0 before the first of them is complete (after `reset_timestep 0` the first average of N steps is complete at step N). Averages in progress are saved in restart files.",
	.example = "fix load all ave/error 100 c_push[2] v_traction\n"
		   "fix profile all ave/error 100 c_T[1] mode vector blocks 64\n"
		   "print \"load $(f_load[1][1]) +- $(f_load[1][2])\"",
	.cite = "H. Flyvbjerg, H. G. Petersen, J. Chem. Phys. 91 (1989) 461",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.hook = {
		[TS_STAGE_SETUP] = set_up,
		[TS_STAGE_END_OF_STEP] = take_sample,
	},
	.fini = fini,
};
