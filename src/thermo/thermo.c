#include "thermo/thermo.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "base/clock.h"
#include "core/ranks.h"
#include "core/recorder.h"
#include "core/report.h"
#include "core/settings.h"
#include "io/csv.h"
#include "particle/particles.h"

#include "base/banned.h"

/* Title of a column: "Step", "KinEng" for keywords; for c_ID, f_ID, v_NAME the part after the prefix, of
 * which LIGGGHTS prints eight characters. LAMMPS prints the whole name. */
static const char *make_title(struct tsim *sim, const char *name)
{
	const struct ts_keyword *keyword = ts_keyword_find(sim->tables, name);
	char eight[9];

	if (keyword)
		return keyword->title;
	if (name[0] && name[1] == '_' && sim->legacy != TS_LEGACY_LAMMPS)
		name += 2;
	snprintf(eight, sizeof eight, "%s", name);
	return ts_arena_strdup(&sim->thermo->arena, sim->legacy == TS_LEGACY_LIGGGHTS ? eight : name);
}

/* Checks a column when it is defined: computes, fixes and variables may be missing until the run, but those
 * that exist must have a scalar. */
static enum ts_status check_column(struct tsim *sim, struct ts_ref_input *input)
{
	enum ts_status status = ts_ref_input_resolve(sim, "thermo_style", TS_WANT(SCALAR), input);

	if (status == TS_OK || !sim->error.missing[0])
		return status;
	ts_error_clear(&sim->error);
	return TS_OK;
}

enum ts_status ts_thermo_columns(struct tsim *sim, struct ts_words names, bool multi)
{
	struct ts_thermo *t = sim->thermo;
	struct ts_words copy;

	t->n = 0;
	t->multi = multi;
	t->norm = t->norm_default;
	for (int k = 0; k < TS_NSTANDARD; k++)
		sim->standard[k] = NULL;
	t->formats = (struct ts_formats){ 0 };
	ts_arena_release(&t->arena);
	TS_TRY(ts_refs_expand(sim, &t->arena, names, TS_WANT(SCALAR), &copy));
	t->column = ts_arena_alloc(&t->arena, copy.n, sizeof *t->column);
	if (!t->column)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < copy.n; k++) {
		t->column[k] = (struct ts_thermo_column){
			.title = make_title(sim, copy.word[k].text),
			.input = { .name = copy.word[k].text, .where = copy.word[k].place },
		};
		if (!t->column[k].title)
			return ts_nomem(&sim->error);
	}
	for (size_t k = 0; k < copy.n; k++)
		TS_TRY(ts_sim_defer_error(sim, check_column(sim, &t->column[k].input)));
	t->n = copy.n;
	return TS_OK;
}

static bool is_integer(const struct ts_thermo_column *c)
{
	return c->input.ref.kind == TS_REF_KEYWORD && c->input.ref.keyword->flags & TS_KEYWORD_INTEGER;
}

static enum ts_status set_formats(struct ts_thermo *t, struct tsim *sim)
{
	for (size_t k = 0; k < t->n; k++) {
		struct ts_thermo_column *c = &t->column[k];
		const struct ts_keyword *keyword = ts_keyword_find(sim->tables, c->input.name);
		bool integer = keyword && keyword->flags & TS_KEYWORD_INTEGER;
		const char *fallback =
			t->multi ? (integer ? "%14d" : "%14.4f") : (integer ? "%8d" : "%14.8g");

		TS_TRY(ts_formats_choose(&t->formats, &sim->error, k, integer, fallback, c->format));
	}
	return TS_OK;
}

enum ts_status ts_thermo_format(struct tsim *sim, struct ts_words words)
{
	struct ts_thermo *t = sim->thermo;

	TS_TRY(ts_formats_change(&t->formats, &sim->error, &t->arena, "thermo_modify", words, t->n));
	return set_formats(t, sim);
}

static enum ts_status resolve_columns(struct ts_thermo *t, struct tsim *sim)
{
	for (size_t k = 0; k < t->n; k++) {
		struct ts_ref_input *input = &t->column[k].input;
		enum ts_status status = ts_ref_input_resolve(sim, "thermo_style", TS_WANT(SCALAR), input);

		if (status == TS_OK)
			status = ts_ref_check(sim, &input->ref, &input->where);
		TS_TRY(ts_sim_defer_error(sim, status));
	}
	return set_formats(t, sim);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_thermo *t = self->state;

	if (report->limits_only)
		return TS_OK;
	TS_TRY(resolve_columns(self->state, sim));
	return ts_report_output(report, "rows of the log", ts_report_count(sim, t->every) + 2,
				16 * (double)t->n) == TS_OK
		       ? TS_OK
		       : ts_nomem(&sim->error);
}

/* Columns of thermo_style one, the default of LIGGGHTS. */
static enum ts_status set_defaults(struct tsim *sim)
{
	const struct ts_word one[] = {
		{ .text = "step" }, { .text = "atoms" }, { .text = "ke" }, { .text = "cpu" }
	};

	return ts_thermo_columns(sim, (struct ts_words){ one, 4 }, false);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_thermo *t = self->state;

	if (!t->n)
		return set_defaults(sim);
	return sim->run.inside ? resolve_columns(t, sim) : TS_OK;
}

/* The table of thermo_log as comma-separated values: names as in thermo_style. */
static enum ts_status begin_table(struct ts_thermo *t, struct tsim *sim)
{
	struct ts_str row = { 0 };

	for (size_t k = 0; k < t->n; k++)
		ts_csv_text(&row, t->column[k].input.name);
	ts_csv_end(&row);
	if (!row.failed && t->table.length && ts_streq(ts_str_text(&row), ts_str_text(&t->table))) {
		ts_str_release(&row);
		return TS_OK;
	}
	if (t->table.length) {
		ts_str_release(&row);
		return ts_fail(&sim->error, TS_STATE, &t->file.where,
			       "thermo_log: the columns have changed since the table '%s' was begun; use "
			       "thermo_log again, with another file",
			       t->file.path);
	}
	ts_str_add(&t->table, ts_str_text(&row));
	return ts_csv_begin(&t->file, sim, &row);
}

static enum ts_status write_line(struct ts_thermo *t, struct tsim *sim)
{
	if (t->line.failed)
		return ts_nomem(&sim->error);
	ts_log(&sim->log, "%s\n", ts_str_text(&t->line));
	TS_TRY(ts_log_flush(&sim->log, &sim->error));
	if (!ts_textfile_is_open(&t->file) || t->csv)
		return TS_OK;
	TS_TRY(ts_textfile_printf(&t->file, "%s\n", ts_str_text(&t->line)));
	return ts_textfile_flush(&t->file);
}

static enum ts_status write_titles(struct ts_thermo *t, struct tsim *sim)
{
	ts_str_clear(&t->line);
	for (size_t k = 0; k < t->n; k++)
		ts_str_addf(&t->line, is_integer(&t->column[k]) ? "%8s " : "%14s ", t->column[k].title);
	return write_line(t, sim);
}

/* "Step     =              0 Atoms    =              2 ", three to a line. */
static void add_named(struct ts_thermo *t, size_t k, double value)
{
	struct ts_thermo_column *c = &t->column[k];

	if (k % 3 == 0)
		ts_str_add(&t->line, "\n");
	ts_str_addf(&t->line, "%-8s = ", c->title);
	ts_format_add(&t->line, c->format, is_integer(c), value);
	ts_str_add(&t->line, " ");
}

enum { USUAL = 14 }; /* width of a title */

/* Adds a number, aligned right under titles that are wider than usual. */
static void add_column(struct ts_thermo *t, size_t k, double value)
{
	struct ts_thermo_column *c = &t->column[k];
	size_t start = t->line.length, title = strlen(c->title), width = title > USUAL ? title : 0, n;

	ts_format_add(&t->line, c->format, is_integer(c), value);
	n = t->line.length - start;
	if (n < width) {
		ts_str_addf(&t->line, "%*s", (int)(width - n), "");
		if (!t->line.failed) {
			memmove(t->line.text + start + width - n, t->line.text + start, n);
			memset(t->line.text + start, ' ', width - n);
		}
	}
	ts_str_add(&t->line, " ");
}

static enum ts_status write_row(struct ts_thermo *t, struct tsim *sim)
{
	double cpu = sim->clock.step > sim->clock.first_step ? ts_clock() - sim->clock.wall_start : 0;

	TS_TRY(ts_ranks_tell(sim));
	ts_str_clear(&t->line);
	if (t->multi)
		ts_str_addf(&t->line,
			    "---------------- Step %8" PRId64 " ----- CPU = %11.4f (sec) ----------------",
			    sim->clock.step, cpu);
	for (size_t k = 0; k < t->n; k++) {
		struct ts_thermo_column *c = &t->column[k];

		TS_TRY(ts_ref_input_scalar(sim, &c->input, &c->value));
		if (t->csv)
			ts_csv_real(&t->table_row, c->value);
		if (t->multi) {
			add_named(t, k, c->value);
			continue;
		}
		add_column(t, k, c->value);
	}
	t->last_row_time = ts_clock() - sim->clock.wall_start;
	t->last_row_step = sim->clock.step;
	if (t->csv) {
		ts_csv_end(&t->table_row);
		TS_TRY(ts_csv_write(&t->file, sim, &t->table_row));
	}
	if (sim->recorder)
		sim->recorder->row(sim->recorder, sim);
	if (sim->row_listener.call)
		TS_TRY(sim->row_listener.call(sim));
	return write_line(t, sim);
}

static bool ends_run(const struct tsim *sim)
{
	const struct ts_clock *c = &sim->clock;

	return (c->step == c->last_step && !sim->run.in_pieces) || (sim->requests.stop && sim->run.complete);
}

static bool asks(const struct ts_thermo *t, int64_t step)
{
	return t->variable ? step == t->next : t->every && step % t->every == 0;
}

/* Once a row is counted, `next` is the step of the one after it. */
bool ts_thermo_is_due(const struct tsim *sim)
{
	const int64_t step = sim->clock.step;

	return ends_run(sim) || sim->thermo->counted == step + 1 || asks(sim->thermo, step);
}

/* Whether a row is due. Only rows due by `every` or `variable`, each once, may advance variables that read
 * from files (reading.probing is false): then a run cut in two reads the same lines as the whole run. */
static enum ts_status is_due(struct ts_thermo *t, struct tsim *sim, bool *due)
{
	const struct ts_clock *c = &sim->clock;
	bool asked = asks(t, c->step);

	*due = asked || c->step == c->first_step || ends_run(sim);
	sim->reading.probing = !asked || t->counted == c->step + 1;
	if (asked)
		t->counted = c->step + 1;
	if (t->variable && (c->step == c->first_step || c->step == t->next))
		return ts_sim_next_step(sim, "thermo", "row", t->variable, NULL, &t->next);
	return TS_OK;
}

/* Whether the ranks can evaluate the column together while the particles are divided. */
static bool is_sum(const struct tsim *sim, const struct ts_thermo_column *c)
{
	enum { ALONE = TS_KEYWORD_CONSTANT | TS_KEYWORD_CLOCK | TS_KEYWORD_BOX | TS_KEYWORD_FLUID };
	const struct ts_keyword *keyword = ts_keyword_find(sim->tables, c->input.name);
	const struct ts_ref *ref = &c->input.ref;
	struct ts_word word = { .text = c->input.name };

	if (keyword)
		return keyword->flags & (ALONE | TS_KEYWORD_SUM) && !(keyword->flags & TS_KEYWORD_FIELDS);
	if (ref->inst && ref->removals == sim->removals && ref->inst->style->ranks & TS_RANKS_SUMS)
		return !sim->particles->dynamic[ref->inst->group].every;
	return !ts_ranks_find_shared(sim, (struct ts_words){ &word, 1 }) &&
	       !ts_ranks_variable_reads_fluid(sim, word.text);
}

/* Whether an outside program may read particles at a row. */
static bool is_watched(const struct tsim *sim)
{
	return !sim->run.pauses || sim->row_listener.call ||
	       (sim->recorder && sim->recorder->records(sim->recorder));
}

/* Whether a row may be due that needs all particles. */
static bool may_be_due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_thermo *t = self->state;
	int64_t step = sim->clock.step;

	if (step != sim->clock.first_step && step != sim->clock.last_step &&
	    !(t->variable ? step >= t->next : t->every && step % t->every == 0))
		return false;
	for (size_t k = 0; k < t->n; k++)
		if (!is_sum(sim, &t->column[k]))
			return true;
	return is_watched(sim) || t->variable;
}

static void names(const struct ts_instance *self, void (*tell)(void *data, const char *text), void *data)
{
	const struct ts_thermo *t = self->state;

	for (size_t k = 0; k < t->n; k++)
		tell(data, t->column[k].input.name);
	if (t->variable)
		tell(data, t->variable);
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct ts_thermo *t = self->state;
	const struct ts_clock *c = &sim->clock;
	bool first = c->step == c->first_step, due;
	enum ts_status status;

	if (first || t->variable)
		ts_deferred_loops_run(sim);
	if (first) {
		t->last_row_step = c->step;
		t->last_row_time = 0;
		ts_progress_begin(&t->progress, sim);
		TS_TRY(resolve_columns(t, sim));
		if (!t->multi)
			TS_TRY(write_titles(t, sim));
		if (t->csv)
			TS_TRY(begin_table(t, sim));
	}
	TS_TRY(is_due(t, sim, &due));
	if (due)
		ts_deferred_loops_run(sim);
	status = due ? write_row(t, sim) : TS_OK;
	sim->reading.probing = false;
	if (!first)
		ts_progress_step(&t->progress, sim);
	return status;
}

static enum ts_status finish(struct ts_instance *self, struct tsim *sim)
{
	(void)self;
	ts_log_progress(&sim->log, "");
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct ts_thermo *t = self->state;

	ts_textfile_close(&t->file);
	ts_str_release(&t->table);
	ts_str_release(&t->table_row);
	ts_str_release(&t->line);
	ts_arena_release(&t->arena);
}

static const struct ts_saved saved[] = { TS_SAVE_I64(struct ts_thermo, counted), TS_SAVED_ROWS_END };

static void settings(const struct ts_instance *self, const struct tsim *sim, struct ts_str *out)
{
	const struct ts_thermo *t = self->state;

	(void)sim;
	ts_setting(out, t->every == 0, "thermo %lld", (long long)t->every);
	ts_setting(out, t->norm_default, "norm %s", t->norm ? "yes" : "no");
}

const struct ts_system_style ts_thermo_system = {
	.style = {
		.name = "thermo",
		.kind = TS_KIND_SYSTEM,
		.summary = "Thermo output, progress line",
		.state_size = sizeof(struct ts_thermo),
		.saved = saved,
		.init = init,
		.plan = plan,
		.hook = {
			[TS_STAGE_OUTPUT] = output,
			[TS_STAGE_FINISH] = finish,
		},
		.defers = TS_DEFERS(OUTPUT),
		.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
		.due = may_be_due,
		.names = names,
		.fini = fini,
	},
	.slot = offsetof(struct tsim, thermo),
	.settings = settings,
	.keywords = ts_thermo_keywords,
};
