/* Fix ave/correlate: time correlation functions of global values. */
#include "core/ref_list.h"
#include "core/sim.h"
#include "io/csv.h"
#include "io/last_step.h"
#include "io/textfile.h"

#include <string.h>

#include "base/banned.h"

enum { AUTO, UPPER, LOWER, AUTO_UPPER, AUTO_LOWER, FULL };
enum { ONE, RUNNING };

struct state {
	int64_t every, repeat, freq, start;
	struct ts_words words;
	int type, ave;
	double prefactor;
	const char *file, *append, *title[3];
	bool overwrite;
	struct ts_ref_list input;
	size_t (*pair)[2], npairs; /* [npairs] indices of the inputs V_i, V_j */
	struct ts_textfile out;
	struct ts_str text;

	/* state, written to restart files */
	int64_t started; /* 1: the arrays exist */
	int64_t last;	 /* step of the last sample */
	int64_t samples; /* in the ring buffer, at most Nrepeat */
	int64_t newest;	 /* index of the newest of them */
	double *ring;	 /* [Nrepeat][inputs] ring buffer of samples */
	double *sum;	 /* [lag][npairs] of V_i(t) V_j(t + lag) */
	double *count;	 /* [lag] number of products */
	double *result;	 /* [lag][2 + npairs] lag in steps, count, correlations */
	size_t ring_n, sum_n, count_n, result_n;
	size_t ring_capacity, sum_capacity, count_capacity, result_capacity;
};

/* Whether the keyword `type` includes the pair V_i, V_j. */
static bool type_includes(int type, size_t i, size_t j)
{
	switch (type) {
	case AUTO:
		return i == j;
	case UPPER:
		return i < j;
	case LOWER:
		return i > j;
	case AUTO_UPPER:
		return i <= j;
	case AUTO_LOWER:
		return i >= j;
	default:
		return true;
	}
}

static enum ts_status list_pairs(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	size_t n = s->input.n;

	s->pair = ts_arena_alloc(&self->arena, n * n, sizeof *s->pair);
	if (!s->pair)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < n; i++)
		for (size_t j = 0; j < n; j++)
			if (type_includes(s->type, i, j)) {
				s->pair[s->npairs][0] = i;
				s->pair[s->npairs++][1] = j;
			}
	if (s->npairs)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &self->where,
		       "fix ave/correlate: this type needs more than one value");
}

static enum ts_status allocate_arrays(struct state *s, struct tsim *sim)
{
	size_t lags = (size_t)s->repeat;

	s->ring_n = lags * s->input.n;
	s->sum_n = lags * s->npairs;
	s->count_n = lags;
	s->result_n = lags * (s->npairs + 2);
	if (TS_GROW(s->ring, s->ring_capacity, s->ring_n) != TS_OK ||
	    TS_GROW(s->sum, s->sum_capacity, s->sum_n) != TS_OK ||
	    TS_GROW(s->count, s->count_capacity, s->count_n) != TS_OK ||
	    TS_GROW(s->result, s->result_capacity, s->result_n) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

static const char *path_of(const struct state *s)
{
	return s->file ? s->file : s->append;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->freq % s->every != 0 || (s->repeat - 1) * s->every > s->freq)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix ave/correlate: Nfreq (%lld) must be a multiple of Nevery (%lld) and not "
			       "less than Nrepeat - 1 (%lld) times Nevery",
			       (long long)s->freq, (long long)s->every, (long long)s->repeat - 1);
	if (s->append && (s->file || s->overwrite))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix ave/correlate: append cannot be used with %s",
			       s->file ? "file" : "overwrite");
	if (ts_csv_is(path_of(s)) && (s->title[0] || s->title[1] || s->title[2]))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix ave/correlate: a table of comma-separated values has no title lines");
	TS_TRY(ts_ref_list_init(sim, "fix ave/correlate", &self->arena, s->words, TS_WANT(SCALAR),
				&s->input));
	if (s->started)
		return TS_OK;
	s->started = 1;
	s->last = -1;
	TS_TRY(list_pairs(self, sim));
	return allocate_arrays(s, sim);
}

/* Adds V_i(t) V_j(t + lag) for t + lag the newest sample and t each sample in the ring buffer. */
static void add_products(struct state *s)
{
	size_t n = s->input.n, lags = (size_t)s->repeat;
	const double *now = s->ring + (size_t)s->newest * n;

	for (size_t lag = 0; lag < (size_t)s->samples; lag++) {
		const double *then = s->ring + ((size_t)s->newest + lags - lag) % lags * n;

		s->count[lag]++;
		for (size_t k = 0; k < s->npairs; k++)
			s->sum[lag * s->npairs + k] += then[s->pair[k][0]] * now[s->pair[k][1]];
	}
}

static void compute_correlations(struct state *s)
{
	for (size_t lag = 0; lag < (size_t)s->repeat; lag++) {
		double *row = s->result + lag * (s->npairs + 2);

		row[0] = (double)lag * (double)s->every;
		row[1] = s->count[lag];
		for (size_t k = 0; k < s->npairs; k++)
			row[2 + k] = s->count[lag] > 0
					     ? s->prefactor * s->sum[lag * s->npairs + k] / s->count[lag]
					     : 0;
	}
}

static void add_titles(const struct ts_instance *self)
{
	struct state *s = self->state;

	ts_str_clear(&s->text);
	if (s->title[0])
		ts_str_addf(&s->text, "%s\n", s->title[0]);
	else
		ts_str_addf(&s->text, "# Time-correlated data for fix %s\n", self->id);
	ts_str_addf(&s->text, "%s\n", s->title[1] ? s->title[1] : "# Timestep Number-of-time-windows");
	ts_str_addf(&s->text, "%s", s->title[2] ? s->title[2] : "# Index TimeDelta Ncount");
	for (size_t k = 0; !s->title[2] && k < s->npairs; k++)
		ts_str_addf(&s->text, " %s*%s", s->input.item[s->pair[k][0]].name,
			    s->input.item[s->pair[k][1]].name);
	ts_str_add(&s->text, "\n");
}

static enum ts_status begin_table(struct state *s, struct tsim *sim)
{
	static const char *const names[] = { "step", "index", "lag", "count" };

	ts_csv_names(&s->text, names, sizeof names / sizeof *names);
	for (size_t k = 0; k < s->npairs; k++) {
		struct ts_str name = { 0 };

		ts_str_addf(&name, "%s*%s", s->input.item[s->pair[k][0]].name,
			    s->input.item[s->pair[k][1]].name);
		ts_csv_text(&s->text, ts_str_text(&name));
		s->text.failed |= name.failed;
		ts_str_release(&name);
	}
	ts_csv_end(&s->text);
	return ts_csv_begin(&s->out, sim, &s->text);
}

static void add_csv_row(struct state *s, const struct tsim *sim, size_t lag)
{
	ts_csv_int(&s->text, sim->clock.step);
	ts_csv_int(&s->text, (int64_t)lag + 1);
	for (size_t k = 0; k < 2 + s->npairs; k++)
		ts_csv_real(&s->text, s->result[lag * (s->npairs + 2) + k]);
	ts_csv_end(&s->text);
}

static void add_row(struct state *s, size_t lag)
{
	const double *row = s->result + lag * (s->npairs + 2);

	ts_str_addf(&s->text, "%zu %.0f %.0f", lag + 1, row[0], row[1]);
	for (size_t k = 0; k < s->npairs; k++)
		ts_str_addf(&s->text, " %g", row[2 + k]);
	ts_str_add(&s->text, "\n");
}

static enum ts_status write_result(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const char *path = path_of(s);
	bool csv = ts_csv_is(path);

	if (!path)
		return TS_OK;
	if (s->overwrite)
		TS_TRY(ts_textfile_close(&s->out));
	ts_str_clear(&s->text);
	if (!ts_textfile_is_open(&s->out)) {
		TS_TRY(ts_textfile_open(&s->out, sim, ts_instance_word(self, path), path, s->append != NULL));
		ts_last_step_warn(&s->out, sim, csv ? TS_STEP_ROWS : TS_STEP_BLOCKS, sim->clock.step);
		if (csv)
			TS_TRY(begin_table(s, sim));
		else
			add_titles(self);
	}
	if (!csv)
		ts_str_addf(&s->text, "%lld %lld\n", (long long)sim->clock.step, (long long)s->repeat);
	for (size_t lag = 0; lag < (size_t)s->repeat; lag++) {
		if (csv)
			add_csv_row(s, sim, lag);
		else
			add_row(s, lag);
	}
	if (s->text.failed)
		return ts_nomem(&sim->error);
	TS_TRY(ts_textfile_write(&s->out, ts_str_text(&s->text), s->text.length));
	return ts_textfile_flush(&s->out);
}

static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return sim->clock.step % s->every == 0 && sim->clock.step >= s->start;
}

static enum ts_status sample(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	int64_t step = sim->clock.step;

	if (!due(self, sim) || step == s->last)
		return TS_OK;
	s->last = step;
	s->newest = (s->newest + 1) % s->repeat;
	s->samples += s->samples < s->repeat;
	TS_TRY(ts_ref_list_scalars(sim, &s->input, s->ring + (size_t)s->newest * s->input.n));
	add_products(s);
	if (step % s->freq != 0)
		return TS_OK;
	compute_correlations(s);
	if (s->ave == ONE) { /* this sample is also the first of the next average */
		memset(s->sum, 0, s->sum_n * sizeof *s->sum);
		memset(s->count, 0, s->count_n * sizeof *s->count);
		s->samples = 1;
		add_products(s);
	}
	return write_result(self, sim);
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;

	(void)sim;
	TS_TRY(ts_archive_fixed(a, "ring", TS_SAVED_F64, s->ring, s->ring_n));
	TS_TRY(ts_archive_fixed(a, "sum", TS_SAVED_F64, s->sum, s->sum_n));
	TS_TRY(ts_archive_fixed(a, "count", TS_SAVED_F64, s->count, s->count_n));
	TS_TRY(ts_archive_fixed(a, "result", TS_SAVED_F64, s->result, s->result_n));
	if (s->newest >= 0 && s->newest < s->repeat && s->samples >= 0 && s->samples <= s->repeat)
		return TS_OK;
	return ts_fail(&sim->error, TS_DAMAGED, &self->where, "impossible state of fix ave/correlate");
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	TS_TRY(ts_table_resize(out, (size_t)s->repeat, s->npairs + 2));
	memcpy(out->data, s->result, s->result_n * sizeof *s->result);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_textfile_close(&s->out);
	ts_str_release(&s->text);
	ts_ref_list_release(&s->input);
	ts_free(s->ring);
	ts_free(s->sum);
	ts_free(s->count);
	ts_free(s->result);
}

static const char *const types[] = {
	[AUTO] = "auto",
	[UPPER] = "upper",
	[LOWER] = "lower",
	[AUTO_UPPER] = "auto/upper",
	[AUTO_LOWER] = "auto/lower",
	[FULL] = "full",
	NULL,
};
static const char *const averages[] = { [ONE] = "one", [RUNNING] = "running", NULL };

#define STEPS(name_, field, help_)                                                                   \
	TS_INT(name_, struct state, field, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN, \
	       .lo = 1, .hi = 1e9, .help = help_)
static const struct ts_arg args[] = {
	STEPS("Nevery", every, "steps between samples"),
	STEPS("Nrepeat", repeat, "number of lags: 0, Nevery, 2 Nevery ..."),
	STEPS("Nfreq", freq, "steps between results"),
	TS_LIST_STATEFUL("values", struct state, words,
			 .help = "c_ID, c_ID[k], c_ID[*], f_ID, f_ID[k], v_NAME or thermo keywords"),
	TS_ENUM("type", struct state, type, types, .flags = TS_STATEFUL, .fallback = "auto",
		.help = "pairs ij to correlate: i = j (auto), i < j (upper), i > j (lower), or all (full)"),
	TS_ENUM("ave", struct state, ave, averages, .flags = TS_STATEFUL, .fallback = "one",
		.help = "one: each result is from the samples since the previous one; running: from all"),
	TS_INT("start", struct state, start, .flags = TS_STATEFUL, .range = TS_NOT_NEGATIVE, .fallback = "0",
	       .help = "no samples before this step"),
	TS_REAL("prefactor", struct state, prefactor, .flags = TS_STATEFUL, .fallback = "1",
		.help = "factor by which the results are multiplied"),
	TS_WORD("file", struct state, file, .flags = TS_OPTIONAL | TS_WRITES,
		.help = "file to write; a table of comma-separated values if its name ends in .csv"),
	TS_WORD("append", struct state, append, .flags = TS_OPTIONAL | TS_WRITES,
		.help = "file to append to"),
	TS_FLAG("overwrite", struct state, overwrite, .help = "the file holds only the last result"),
	TS_WORD("title1", struct state, title[0], .flags = TS_OPTIONAL, .help = "first line of the file"),
	TS_WORD("title2", struct state, title[1], .flags = TS_OPTIONAL, .help = "second line of the file"),
	TS_WORD("title3", struct state, title[2], .flags = TS_OPTIONAL, .help = "third line of the file"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ .name = "correlations",
	  .unit = "",
	  .help = "a row for each lag: the lag in steps, number of products, then their mean for each pair "
		  "of values",
	  .shape = TS_ARRAY,
	  .eval = eval },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct state, started),
	TS_SAVE_I64(struct state, last),
	TS_SAVE_I64(struct state, samples),
	TS_SAVE_I64(struct state, newest),
	TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_ave_correlate)
const struct ts_style ts_fix_ave_correlate = {
	.name = "ave/correlate",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = due,
	.summary = "Time correlation functions of global values",
	.doc = "Calculates the time correlation functions of pairs of values,\n\n"
	       "    C_ij(lag) = prefactor < V_i(t) V_j(t + lag) >\n\n"
	       "where < > is the mean over all samples. Every Nfreq steps the results are updated and written to the file; with `ave one` the sums are then set to zero, and the sample of that step is the first of the next result. trap(f_ID[3]) is the integral of the first correlation over the lag in units of Nevery steps.",
	.example = "fix memory all ave/correlate 5 20 1000 c_force[1] c_force[2] type auto ave running file acf.txt",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.hook = {
		[TS_STAGE_SETUP] = sample,
		[TS_STAGE_END_OF_STEP] = sample,
	},
	.fini = fini,
};
