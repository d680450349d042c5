/* Fix ave/time: time averages of global values. */
#include "average/average.h"
#include "average/average_file.h"
#include "average/chunk_user.h"
#include "io/csv.h"
#include "core/ref_list.h"
#include "core/report.h"

#include <string.h>

#include "base/banned.h"

enum { SCALAR, VECTOR };

struct state {
	struct ts_average average;
	struct ts_average_file file;
	struct ts_words names, off;
	int mode;
	struct ts_ref_list input;
	bool *as_it_is; /* [value] true: not averaged (keyword `off`) */
	struct ts_table vector;
	bool unmeasured; /* no style has told the number of rows, and there was no set-up to find it */
	int64_t rows; /* elements of each value, 1 for scalars; written to restart files. Element i of value k
		       * is number k * rows + i of the average */
};

static enum ts_status read_off(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->as_it_is = ts_arena_alloc(&self->arena, s->input.n, sizeof *s->as_it_is);
	if (!s->as_it_is)
		return ts_nomem(&sim->error);
	for (size_t w = 0; w < s->off.n; w++) {
		int64_t k;

		if (!ts_parse_int(s->off.word[w].text, &k) || k < 1 || k > (int64_t)s->input.n)
			return ts_fail(&sim->error, TS_RANGE, &s->off.word[w].place,
				       "fix ave/time: off takes the number of a value, from 1 to %zu",
				       s->input.n);
		s->as_it_is[k - 1] = true;
	}
	return TS_OK;
}

/* Elements of each vector, if its style tells before it is evaluated; 0: it does not. */
static int64_t rows_told(const struct state *s, const struct tsim *sim)
{
	const struct ts_ref *first = &s->input.item[0].ref;
	const struct ts_value *vector =
		first->inst && !first->index ? ts_value_find(first->inst, TS_VECTOR) : NULL;

	if (first->inst)
		return vector ? (int64_t)ts_value_width(first->inst, vector) : 0;
	return (int64_t)ts_ref_standard_elements(sim, first->name);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	bool first = !s->average.started;

	TS_TRY(ts_average_init(self, sim, &s->average));
	s->file.blocks = s->mode == VECTOR;
	TS_TRY(ts_average_file_init(self, sim, &s->file));
	TS_TRY(ts_ref_list_init(sim, "fix ave/time", &self->arena, s->names,
				s->mode == VECTOR ? TS_WANT(VECTOR) | TS_WANT_COLUMNS : TS_WANT(SCALAR),
				&s->input));
	if (!s->as_it_is)
		TS_TRY(read_off(self, sim));
	if (!first)
		return TS_OK;
	s->rows = s->mode == VECTOR ? rows_told(s, sim) : 1;
	s->unmeasured = s->rows == 0;
	s->rows = s->rows ? s->rows : 1;
	return ts_average_resize(self, sim, &s->average, s->input.n * (size_t)s->rows);
}

/* Whether an input would determine its chunks for good, which the first sample has to do. */
static enum ts_status any_keeps_chunks(const struct state *s, struct tsim *sim, bool *keeps)
{
	*keeps = false;
	for (size_t k = 0; k < s->input.n && !*keeps; k++)
		TS_TRY(ts_chunk_user_keeps(sim, &s->input.item[k], keeps));
	return TS_OK;
}

/* Vectors whose style does not tell their length are evaluated once for it: outputs before the first sample read their elements.
 * Where that is not possible yet, the first sample tells. */
static enum ts_status measure_rows(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	bool keeps;

	if (!s->unmeasured)
		return TS_OK;
	s->unmeasured = false;
	TS_TRY(any_keeps_chunks(s, sim, &keeps));
	if (keeps || s->average.samples || s->average.averages) /* the latter of a restart file */
		return TS_OK;
	if (ts_ref_list_table(sim, &s->input, &s->vector) != TS_OK) {
		ts_error_clear(&sim->error); /* told by the first sample */
		return TS_OK;
	}
	s->rows = s->vector.rows ? (int64_t)s->vector.rows : 1;
	return ts_average_resize(self, sim, &s->average, s->input.n * (size_t)s->rows);
}

/* Adds element i of value k to the sums; `off` values are replaced by the latest sample. */
static void add_to_sum(struct state *s, size_t k, size_t i, double value)
{
	double *sum = &s->average.sum[k * (size_t)s->rows + i];

	*sum = s->as_it_is[k] ? value : *sum + value;
}

static enum ts_status sample_scalars(struct state *s, struct tsim *sim)
{
	for (size_t k = 0; k < s->input.n; k++) {
		double value;

		TS_TRY(ts_ref_input_scalar(sim, &s->input.item[k], &value));
		add_to_sum(s, k, 0, value);
	}
	return TS_OK;
}

/* The first sample of an average sets the length of the vectors; the other samples must have the same. */
static enum ts_status sample_vectors(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	size_t n = s->input.n, length;

	for (size_t k = 0; s->average.samples == 0 && k < n; k++)
		TS_TRY(ts_chunk_user_hold(sim, &s->input.item[k], ts_average_until(&s->average, sim)));
	TS_TRY(ts_ref_list_table(sim, &s->input, &s->vector));
	length = s->vector.rows;
	if (s->average.samples == 0) {
		TS_TRY(ts_average_resize(self, sim, &s->average, length * n));
		s->rows = (int64_t)length;
		for (size_t k = 0; k < length * n; k++)
			s->average.sum[k] = 0;
	}
	if ((int64_t)length != s->rows)
		return ts_fail(&sim->error, TS_STATE, &s->input.item[0].where,
			       "fix ave/time: '%s' has %zu elements, expected %lld", s->input.item[0].name,
			       length, (long long)s->rows);
	for (size_t k = 0; k < n; k++)
		for (size_t i = 0; i < length; i++)
			add_to_sum(s, k, i, s->vector.data[i * n + k]);
	return TS_OK;
}

static void add_names(struct state *s, struct ts_str *line)
{
	for (size_t k = 0; k < s->input.n; k++)
		ts_str_addf(line, " %s", s->input.item[k].name);
}

static enum ts_status add_titles(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_str line = { 0 };
	bool failed;

	ts_str_addf(&line, "# Time-averaged data for fix %s", self->id);
	ts_average_file_title(&s->file, 0, ts_str_text(&line));
	ts_str_clear(&line);
	ts_str_addf(&line, "# TimeStep%s", s->mode == VECTOR ? " Number-of-rows" : "");
	if (s->mode == SCALAR)
		add_names(s, &line);
	ts_average_file_title(&s->file, 1, ts_str_text(&line));
	ts_str_clear(&line);
	ts_str_add(&line, "# Row");
	add_names(s, &line);
	if (s->mode == VECTOR)
		ts_average_file_title(&s->file, 2, ts_str_text(&line));
	failed = line.failed;
	ts_str_release(&line);
	return failed ? ts_nomem(&sim->error) : TS_OK;
}

static enum ts_status add_csv_names(struct state *s, struct tsim *sim)
{
	ts_csv_text(&s->file.text, "step");
	if (s->mode == VECTOR)
		ts_csv_text(&s->file.text, "row");
	for (size_t k = 0; k < s->input.n; k++)
		ts_csv_text(&s->file.text, s->input.item[k].name);
	return ts_average_file_names_done(sim, &s->file);
}

/* The numbers before the values of a row: in a table the step is in each. */
static void begin_row(struct state *s, const struct tsim *sim, size_t row)
{
	struct ts_str *text = &s->file.text;

	if (!s->file.csv) {
		ts_str_addf(text, "%lld",
			    s->mode == VECTOR ? (long long)row + 1 : (long long)sim->clock.step);
		return;
	}
	ts_csv_int(text, sim->clock.step);
	if (s->mode == VECTOR)
		ts_csv_int(text, (int64_t)row + 1);
}

static enum ts_status write_result(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_str *text = &s->file.text;
	size_t rows = (size_t)s->rows;
	bool titles;

	if (!ts_average_file_wanted(&s->file))
		return TS_OK;
	TS_TRY(ts_average_file_begin(self, sim, &s->file, &titles));
	if (titles)
		TS_TRY(s->file.csv ? add_csv_names(s, sim) : add_titles(self, sim));
	if (s->mode == VECTOR && !s->file.csv)
		ts_str_addf(text, "%lld %zu\n", (long long)sim->clock.step, rows);
	for (size_t i = 0; i < rows; i++) {
		begin_row(s, sim, i);
		for (size_t k = 0; k < s->input.n; k++)
			ts_average_file_number(&s->file, s->average.result[k * rows + i]);
		ts_str_add(text, "\n");
	}
	return ts_average_file_end(sim, &s->file);
}

/* Divides the sums by the number of samples, but for `off` values, which `ave` does not combine either. */
static void complete_average(struct state *s)
{
	size_t rows = (size_t)s->rows;

	for (size_t k = 0; k < s->average.n; k++)
		if (!s->as_it_is[k / rows])
			s->average.sum[k] /= (double)s->average.repeat;
	ts_average_combine(&s->average);
	for (size_t k = 0; k < s->average.n; k++)
		if (s->as_it_is[k / rows])
			s->average.result[k] = s->average.sum[k];
}

static enum ts_status sample(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (!ts_average_due(&s->average, sim))
		return TS_OK;
	TS_TRY(s->mode == VECTOR ? sample_vectors(self, sim) : sample_scalars(s, sim));
	if (!ts_average_sampled(&s->average, sim))
		return TS_OK;
	complete_average(s);
	return write_result(self, sim);
}

static enum ts_status set_up(struct ts_instance *self, struct tsim *sim)
{
	TS_TRY(measure_rows(self, sim));
	return sample(self, sim);
}

static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	return ((const struct state *)self->state)->unmeasured || ts_average_waits(self, sim);
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;

	TS_TRY(ts_average_archive(self, sim, a, &s->average));
	if (s->rows < 0 || s->average.n != s->input.n * (size_t)s->rows)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix ave/time %s: the restart file holds averages of another number of values "
			       "or another window",
			       self->id);
	return TS_OK;
}

static enum ts_status eval_scalar(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	out->data[0] = s->average.n ? s->average.result[0] : 0;
	return TS_OK;
}

/* mode scalar: one element per value; mode vector: the elements of the first value. */
static enum ts_status eval_vector(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t n = s->mode == VECTOR ? (size_t)s->rows : s->average.n;

	(void)sim;
	TS_TRY(ts_table_resize(out, 1, n));
	if (n)
		memcpy(out->data, s->average.result, n * sizeof *s->average.result);
	return TS_OK;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;

	return ts_average_file_plan(&s->file, sim, s->average.freq, s->rows > 1 ? (size_t)s->rows : 1,
				    s->input.n, report);
}

static enum ts_status eval_array(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t rows = (size_t)s->rows, n = s->input.n;

	(void)sim;
	TS_TRY(ts_table_resize(out, rows, n));
	for (size_t k = 0; k < n; k++)
		for (size_t i = 0; i < rows; i++)
			out->data[i * n + k] = s->average.result[k * rows + i];
	return TS_OK;
}

static bool gives(const struct ts_instance *self, const struct ts_value *value)
{
	return value->shape != TS_ARRAY || ((const struct state *)self->state)->mode == VECTOR;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_average_file_release(&s->file);
	ts_average_release(&s->average);
	ts_table_release(&s->vector);
	ts_ref_list_release(&s->input);
}

static const char *const kinds[] = { [SCALAR] = "scalar", [VECTOR] = "vector", NULL };

static const struct ts_arg window_row[] = { TS_AVERAGE_WINDOW_ROW(struct state, average), TS_ARGS_END };
static const struct ts_mode combinations[] = TS_AVERAGE_MODES;

static const struct ts_arg args[] = {
	TS_AVERAGE_STEPS(struct state, average),
	TS_LIST_STATEFUL("values", struct state, names,
			 .help = "c_ID, c_ID[k], c_ID[*], f_ID, f_ID[k], v_NAME or thermo keywords"),
	TS_ENUM("mode", struct state, mode, kinds, .flags = TS_STATEFUL, .fallback = "scalar",
		.help = "whether values are scalars or vectors"),
	TS_AVERAGE_KEYWORDS(struct state, average),
	TS_LIST_KEYWORD("off", struct state, off,
			.flags = TS_OPTIONAL | TS_TO_KEYWORD | TS_REPEAT | TS_STATEFUL,
			.help = "number of a value that is not averaged; repeat for more"),
	TS_AVERAGE_FILE_ARGS(struct state, file),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ .name = "average",
	  .unit = "",
	  .help = "the average of the first value",
	  .shape = TS_SCALAR,
	  .columns = 1,
	  .eval = eval_scalar },
	{ .name = "averages",
	  .unit = "",
	  .help = "the averages of the values; with mode vector the elements of the first value",
	  .shape = TS_VECTOR,
	  .eval = eval_vector },
	{ .name = "table",
	  .unit = "",
	  .help = "with mode vector: a column for each value",
	  .shape = TS_ARRAY,
	  .eval = eval_array },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_AVERAGE_SAVED(struct state, average),
	TS_SAVE_I64(struct state, rows),
	TS_SAVED_ROWS_END,
};

static const struct ts_arg_group groups[] = {
	{ NULL, "Nevery Nrepeat Nfreq values mode ave file" },
	{ "What is averaged", "start off" },
	TS_AVERAGE_FILE_GROUP,
	{ .words = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_ave_time)
const struct ts_style ts_fix_ave_time = {
	.name = "ave/time",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = due,
	.summary = "Time averages of global values",
	.doc = "Calculates every Nfreq steps the mean of Nrepeat samples taken Nevery steps apart, the last at that step: with 2 6 100 the samples of steps 90, 92, 94, 96, 98, 100. f_ID[k] is the average of value k, f_ID that of the first; with `mode vector` f_ID[i] is element i of the first vector, f_ID[i][k] that of the k-th. Averages are 0 before the first one is complete. A value that is `off` is that of the last sample. Averages in progress are saved in restart files.",
	.example = "fix speed all ave/time 10 100 1000 v_rop c_energy file post/speed.txt ave window 5",
	.args = args,
	.groups = groups,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.gives = gives,
	.init = init,
	.plan = plan,
	.hook = {
		[TS_STAGE_SETUP] = set_up,
		[TS_STAGE_END_OF_STEP] = sample,
	},
	.fini = fini,
};
