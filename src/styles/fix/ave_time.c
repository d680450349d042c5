/* Fix ave/time: averages of numbers over time, as in LAMMPS. */
#include "core/plan.h"
#include "core/ref_list.h"
#include "core/sim.h"
#include "io/textfile.h"

#include <string.h>

#include "base/banned.h"

enum { SCALAR, VECTOR };
enum { ONE, RUNNING, WINDOW };

struct state {
	int64_t every, repeat, freq, start, window;
	struct ts_words names;
	int mode, ave;
	const char *file, *append, *title[3];
	struct ts_ref_list input;
	struct ts_table vector;

	/* saved */
	int64_t next;	 /* step of the next sample           */
	int64_t samples; /* taken of the average under way    */
	int64_t started, averages;
	int64_t rows;	 /* elements of each value; 1 for scalars */
	double *sum;	 /* of the samples under way: value k, element i at [k * rows + i] */
	double *total;	 /* of the averages that `ave` combines */
	double *history; /* the last `window` averages, a ring  */
	double *result;
	size_t n, sum_n, total_n, history_n, result_n; /* n = values * rows */
	size_t sum_capacity, total_capacity, history_capacity, result_capacity;

	struct ts_textfile out;
	struct ts_str text;
};

/* The first sample of the next average that ends on a multiple of freq. */
static int64_t first_sample(const struct state *s, int64_t step)
{
	int64_t length = (s->repeat - 1) * s->every;
	int64_t least = step + length > s->start ? step + length : s->start;

	return (least + s->freq - 1) / s->freq * s->freq - length;
}

static enum ts_status check(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	if (s->freq % s->every != 0 || s->repeat > s->freq / s->every)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix ave/time: Nfreq (%lld) must be a multiple of Nevery (%lld) and "
			       "not less than Nrepeat (%lld) times Nevery",
			       (long long)s->freq, (long long)s->every, (long long)s->repeat);
	if (s->file && s->append)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix ave/time: expected either file or append, found both");
	return TS_OK;
}

/* Makes room for n numbers in each array, zero where new. */
static enum ts_status make_room(struct state *s, struct tsim *sim, size_t n)
{
	size_t ring = s->ave == WINDOW ? n * (size_t)s->window : 0;

	s->n = n;
	if (s->result_n == n && s->history_n == ring)
		return TS_OK;
	if (TS_GROW(s->sum, s->sum_capacity, n) != TS_OK ||
	    TS_GROW(s->total, s->total_capacity, n) != TS_OK ||
	    TS_GROW(s->result, s->result_capacity, n) != TS_OK ||
	    TS_GROW(s->history, s->history_capacity, ring) != TS_OK)
		return ts_nomem(&sim->error);
	s->sum_n = s->total_n = s->result_n = n;
	s->history_n = ring;
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(check(self, sim));
	TS_TRY(ts_ref_list_init(sim, "fix ave/time", &self->arena, s->names,
				s->mode == VECTOR ? TS_WANT(VECTOR) : TS_WANT(SCALAR), &s->input));
	if (s->started)
		return TS_OK;
	s->started = 1;
	s->rows = 1;
	s->next = first_sample(s, sim->clock.step);
	return make_room(s, sim, s->input.n);
}

static enum ts_status sample_scalars(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	for (size_t k = 0; k < s->input.n; k++) {
		double value;

		TS_TRY(ts_ref_input_scalar(sim, &s->input.item[k], &value));
		s->sum[k] += value;
	}
	return TS_OK;
}

/* The length of the vectors is that of the first one at the first sample. */
static enum ts_status sample_vectors(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	size_t n = s->input.n, length;

	TS_TRY(ts_ref_list_table(sim, &s->input, &s->vector));
	length = s->vector.rows;
	if (s->averages == 0 && s->samples == 0) {
		s->rows = (int64_t)length;
		TS_TRY(make_room(s, sim, length * n));
	}
	if ((int64_t)length != s->rows)
		return ts_fail(&sim->error, TS_STATE, &s->input.item[0].where,
			       "fix ave/time: '%s' has %zu elements, expected %lld",
			       s->input.item[0].name, length, (long long)s->rows);
	for (size_t k = 0; k < n; k++)
		for (size_t i = 0; i < length; i++)
			s->sum[k * length + i] += s->vector.data[i * n + k];
	return TS_OK;
}

/* An average is complete: combines it with those before. */
static void combine(struct state *s)
{
	int64_t count = s->averages + 1;
	double *ring = s->history;

	if (s->ave == WINDOW && count > s->window)
		count = s->window;
	for (size_t k = 0; k < s->n; k++) {
		double average = s->sum[k] / (double)s->samples;

		if (s->ave == ONE) {
			s->result[k] = average;
			continue;
		}
		if (s->ave == RUNNING) {
			s->total[k] += average;
			s->result[k] = s->total[k] / (double)count;
			continue;
		}
		ring[(size_t)(s->averages % s->window) * s->n + k] = average;
		s->result[k] = 0;
		for (int64_t j = 0; j < count; j++)
			s->result[k] += ring[(size_t)j * s->n + k];
		s->result[k] /= (double)count;
	}
	s->averages++;
}

static void add_titles(struct ts_instance *self)
{
	struct state *s = self->state;

	if (s->title[0])
		ts_str_addf(&s->text, "%s\n", s->title[0]);
	else
		ts_str_addf(&s->text, "# Time-averaged data for fix %s\n", self->id);
	if (s->title[1]) {
		ts_str_addf(&s->text, "%s\n", s->title[1]);
	} else if (s->mode == VECTOR) {
		ts_str_add(&s->text, "# TimeStep Number-of-rows\n");
	} else {
		ts_str_add(&s->text, "# TimeStep");
		for (size_t k = 0; k < s->input.n; k++)
			ts_str_addf(&s->text, " %s", s->input.item[k].name);
		ts_str_add(&s->text, "\n");
	}
	if (s->mode == SCALAR)
		return;
	ts_str_addf(&s->text, "%s", s->title[2] ? s->title[2] : "# Row");
	for (size_t k = 0; !s->title[2] && k < s->input.n; k++)
		ts_str_addf(&s->text, " %s", s->input.item[k].name);
	ts_str_add(&s->text, "\n");
}

static void add_result(struct state *s, int64_t step)
{
	size_t rows = (size_t)s->rows;

	if (s->mode == VECTOR)
		ts_str_addf(&s->text, "%lld %zu\n", (long long)step, rows);
	for (size_t i = 0; i < rows; i++) {
		ts_str_addf(&s->text, "%lld",
			    s->mode == VECTOR ? (long long)i + 1 : (long long)step);
		for (size_t k = 0; k < s->input.n; k++)
			ts_str_addf(&s->text, " %g", s->result[k * rows + i]);
		ts_str_add(&s->text, "\n");
	}
}

static enum ts_status write_result(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const char *path = s->file ? s->file : s->append;

	if (!path)
		return TS_OK;
	ts_str_clear(&s->text);
	if (!ts_textfile_is_open(&s->out)) {
		TS_TRY(ts_textfile_open(&s->out, &sim->error, ts_instance_word(self, path), path,
					s->append != NULL));
		add_titles(self);
	}
	add_result(s, sim->clock.step);
	if (s->text.failed)
		return ts_nomem(&sim->error);
	TS_TRY(ts_textfile_write(&s->out, ts_str_text(&s->text), s->text.length));
	return ts_textfile_flush(&s->out);
}

static enum ts_status sample(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (sim->clock.step != s->next)
		return TS_OK;
	if (s->samples == 0)
		for (size_t k = 0; k < s->n; k++)
			s->sum[k] = 0;
	TS_TRY(s->mode == VECTOR ? sample_vectors(self, sim) : sample_scalars(self, sim));
	s->samples++;
	s->next += s->every;
	if (s->samples < s->repeat)
		return TS_OK;
	combine(s);
	s->samples = 0;
	s->next = sim->clock.step + s->freq - (s->repeat - 1) * s->every;
	return write_result(self, sim);
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim,
			      struct ts_archive *archive)
{
	struct state *s = self->state;
	size_t expected;

	TS_TRY(ts_archive_array(archive, "sum", TS_SAVED_F64, (void **)&s->sum, &s->sum_capacity,
				&s->sum_n));
	TS_TRY(ts_archive_array(archive, "total", TS_SAVED_F64, (void **)&s->total,
				&s->total_capacity, &s->total_n));
	TS_TRY(ts_archive_array(archive, "history", TS_SAVED_F64, (void **)&s->history,
				&s->history_capacity, &s->history_n));
	TS_TRY(ts_archive_array(archive, "result", TS_SAVED_F64, (void **)&s->result,
				&s->result_capacity, &s->result_n));
	if (ts_archive_writing(archive))
		return TS_OK;
	s->n = s->result_n;
	expected = s->ave == WINDOW ? s->n * (size_t)s->window : 0;
	if (s->samples < 0 || s->samples >= s->repeat || s->averages < 0 || s->rows < 0 ||
	    s->n != s->input.n * (size_t)s->rows || s->sum_n != s->n || s->total_n != s->n ||
	    s->history_n != expected)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix ave/time %s: the restart file holds averages of another number "
			       "of values or another window",
			       self->id);
	return TS_OK;
}

static enum ts_status eval_scalar(struct ts_instance *self, const struct tsim *sim,
				  struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	out->data[0] = s->n ? s->result[0] : 0;
	return TS_OK;
}

/* Scalars: one element per value. Vectors: the elements of the first value. */
static enum ts_status eval_vector(struct ts_instance *self, const struct tsim *sim,
				  struct ts_table *out)
{
	const struct state *s = self->state;
	size_t n = s->mode == VECTOR ? (size_t)s->rows : s->n;

	(void)sim;
	TS_TRY(ts_table_resize(out, 1, n));
	if (n)
		memcpy(out->data, s->result, n * sizeof *s->result);
	return TS_OK;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim,
			   struct ts_plan_report *report)
{
	const struct state *s = self->state;
	const char *path = s->file ? s->file : s->append;
	double rows = s->rows > 1 ? (double)s->rows : 1;

	if (!sim->explain || !path)
		return TS_OK;
	return ts_report_output(report, path, ts_report_times(sim, s->freq),
				rows * (10 + 12 * (double)s->input.n)) == TS_OK
		       ? TS_OK
		       : ts_nomem(&sim->error);
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_textfile_close(&s->out);
	ts_str_release(&s->text);
	ts_table_release(&s->vector);
	ts_ref_list_release(&s->input);
	ts_free(s->sum);
	ts_free(s->total);
	ts_free(s->history);
	ts_free(s->result);
}

static const char *const kinds[] = { [SCALAR] = "scalar", [VECTOR] = "vector", NULL };

static const struct ts_arg window_row[] = {
	TS_INT("M", struct state, window, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN, .lo = 1,
	       .hi = 1e6, .help = "how many averages"),
	TS_ARGS_END,
};

static const struct ts_mode combinations[] = {
	[ONE] = { "one", "each average by itself", NULL },
	[RUNNING] = { "running", "the mean of all averages so far", NULL },
	[WINDOW] = { "window", "the mean of the last M averages", window_row },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_INT("Nevery", struct state, every, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN, .lo = 1,
	       .hi = 1e15, .help = "steps between samples"),
	TS_INT("Nrepeat", struct state, repeat, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN, .lo = 1,
	       .hi = 1e15, .help = "samples per average"),
	TS_INT("Nfreq", struct state, freq, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN, .lo = 1,
	       .hi = 1e15, .help = "steps between averages"),
	TS_LIST_STATEFUL("values", struct state, names,
		.help = "c_ID, c_ID[k], c_ID[*], f_ID, f_ID[k], v_NAME or thermo keywords"),
	TS_ENUM("mode", struct state, mode, kinds, .flags = TS_STATEFUL,
		.fallback = "scalar",
		.help = "whether values are numbers or whole vectors"),
	{ .name = "ave",
	  .type = TS_ARG_MODE,
	  .flags = TS_STATEFUL,
	  .offset = TS_FIELD(struct state, ave, int *),
	  .modes = combinations,
	  .fallback = "one",
	  .help = "what becomes of averages" },
	TS_INT("start", struct state, start, .flags = TS_STATEFUL, .range = TS_WITHIN, .lo = 0, .hi = 1e15,
	       .fallback = "0", .help = "no average before this step"),
	TS_WORD("file", struct state, file, .flags = TS_OPTIONAL | TS_WRITES, .help = "file to write anew"),
	TS_WORD("append", struct state, append, .flags = TS_OPTIONAL | TS_WRITES, .help = "file to continue"),
	TS_WORD("title1", struct state, title[0], .flags = TS_OPTIONAL,
		.help = "first line of the file"),
	TS_WORD("title2", struct state, title[1], .flags = TS_OPTIONAL,
		.help = "second line of the file"),
	TS_WORD("title3", struct state, title[2], .flags = TS_OPTIONAL,
		.help = "third line of the file, for mode vector"),
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
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct state, next),    TS_SAVE_I64(struct state, samples),
	TS_SAVE_I64(struct state, started), TS_SAVE_I64(struct state, averages),
	TS_SAVE_I64(struct state, rows),    TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_ave_time)
const struct ts_style ts_fix_ave_time = {
	.name = "ave/time",
	.kind = TS_KIND_FIX,
	.summary = "Averages numbers over time",
	.doc = "Every Nfreq steps the mean of Nrepeat samples, Nevery steps apart, the last at the step itself:\n"
	       "with 2 6 100 those of steps 90, 92, 94, 96, 98, 100. Results are read as f_ID[k], or f_ID for\n"
	       "the first, and written to a file. They are 0 before the first average. Averages under way are\n"
	       "saved in restart files.",
	.example = "fix speed all ave/time 10 100 1000 v_rop c_energy file post/speed.txt ave window 5",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.plan = plan,
	.hook = {
		[TS_STAGE_SETUP] = sample,
		[TS_STAGE_END_OF_STEP] = sample,
	},
	.fini = fini,
};
