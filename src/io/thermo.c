#include "io/thermo.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "base/clock.h"

#include "base/banned.h"

/* "Step", "KinEng"; of c_ID, f_ID, v_NAME the first eight characters after the prefix. */
static const char *make_title(struct ts_thermo *t, const char *name)
{
	char title[9];

	for (const struct ts_keyword *k = ts_thermo_keywords; k->name; k++)
		if (ts_streq(k->name, name))
			return k->title;
	if (name[0] && name[1] == '_')
		name += 2;
	snprintf(title, sizeof title, "%s", name);
	return ts_arena_strdup(&t->arena, title);
}

enum ts_status ts_thermo_columns(struct tsim *sim, struct ts_words names)
{
	struct ts_thermo *t = sim->thermo;
	struct ts_words copy;

	t->n = 0;
	ts_arena_release(&t->arena);
	TS_TRY(ts_refs_expand(sim, &t->arena, names, TS_WANT(SCALAR), &copy));
	t->column = ts_arena_alloc(&t->arena, copy.n, sizeof *t->column);
	if (!t->column)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < copy.n; k++) {
		t->column[k] = (struct ts_thermo_column){
			.title = make_title(t, copy.word[k].text),
			.input = { .name = copy.word[k].text, .where = copy.word[k].place },
		};
		if (!t->column[k].title)
			return ts_nomem(&sim->error);
	}
	t->n = copy.n;
	return TS_OK;
}

enum ts_status ts_thermo_format(struct tsim *sim, bool integer, const char *format,
				const struct ts_place *where)
{
	struct ts_thermo *t = sim->thermo;

	if (ts_format_check(format, integer, integer ? t->int_format : t->float_format))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, where,
		       "'%s' is no format for one %s, expected for instance %s", format,
		       integer ? "integer" : "number", integer ? "%8d" : "%14.8g");
}

static enum ts_status resolve(struct ts_thermo *t, struct tsim *sim)
{
	for (size_t k = 0; k < t->n; k++)
		TS_TRY(ts_pardon(sim, ts_ref_input_resolve(sim, "thermo_style", TS_WANT(SCALAR),
							   &t->column[k].input)));
	return TS_OK;
}

/* Else they are resolved at the first row. */
static enum ts_status plan(struct ts_instance *self, struct tsim *sim,
			   struct ts_plan_report *report)
{
	(void)report;
	return sim->explain ? resolve(self->state, sim) : TS_OK;
}

/* The columns of `one`, LIGGGHTS' default. */
static enum ts_status set_defaults(struct ts_thermo *t, struct tsim *sim)
{
	const struct ts_word one[] = {
		{ .text = "step" }, { .text = "atoms" }, { .text = "ke" }, { .text = "cpu" }
	};

	TS_TRY(ts_thermo_format(sim, false, "%14.8g", NULL));
	TS_TRY(ts_thermo_format(sim, true, "%8d", NULL));
	(void)t;
	return ts_thermo_columns(sim, (struct ts_words){ one, 4 });
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_thermo *t = self->state;

	if (!t->n)
		return set_defaults(t, sim);
	return sim->running ? resolve(t, sim) : TS_OK;
}

static bool is_integer(const struct ts_thermo_column *c)
{
	return c->input.ref.kind == TS_REF_KEYWORD && c->input.ref.keyword->integer;
}

static enum ts_status emit(struct ts_thermo *t, struct tsim *sim)
{
	if (t->line.failed)
		return ts_nomem(&sim->error);
	ts_log(&sim->log, "%s\n", ts_str_text(&t->line));
	TS_TRY(ts_log_flush(&sim->log, &sim->error));
	if (!ts_textfile_is_open(&t->file))
		return TS_OK;
	TS_TRY(ts_textfile_printf(&t->file, "%s\n", ts_str_text(&t->line)));
	return ts_textfile_flush(&t->file);
}

static enum ts_status header(struct ts_thermo *t, struct tsim *sim)
{
	ts_str_clear(&t->line);
	for (size_t k = 0; k < t->n; k++)
		ts_str_addf(&t->line, is_integer(&t->column[k]) ? "%8s " : "%14s ",
			    t->column[k].title);
	return emit(t, sim);
}

static enum ts_status row(struct ts_thermo *t, struct tsim *sim)
{
	ts_str_clear(&t->line);
	for (size_t k = 0; k < t->n; k++) {
		struct ts_thermo_column *c = &t->column[k];
		bool integer = is_integer(c);
		double value;

		TS_TRY(ts_ref_input_scalar(sim, &c->input, &value));
		ts_format_add(&t->line, integer ? t->int_format : t->float_format, integer, value);
		ts_str_add(&t->line, " ");
	}
	t->last_row_time = ts_clock() - sim->clock.wall_start;
	t->last_row_step = sim->clock.step;
	return emit(t, sim);
}

static void progress(struct ts_thermo *t, struct tsim *sim)
{
	const struct ts_clock *c = &sim->clock;
	double now = ts_clock(), spent = now - c->wall_start, left, percent;
	char text[128];

	if (now < t->progress_due || sim->in_pieces || c->step == c->first_step)
		return;
	t->progress_due = now + 0.2;
	percent = 100 * (double)(c->step - c->first_step) / (double)(c->last_step - c->first_step);
	left = spent * (100 - percent) / percent;
	snprintf(text, sizeof text,
		 "%5.1f %%  step %" PRId64 " of %" PRId64 "  %.0f s, %.0f s left", percent, c->step,
		 c->last_step, spent, left);
	ts_log_progress(&sim->log, text);
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct ts_thermo *t = self->state;
	const struct ts_clock *c = &sim->clock;
	bool first = c->step == c->first_step;

	if (first) {
		t->last_row_step = c->step;
		t->last_row_time = t->progress_due = 0;
		TS_TRY(resolve(t, sim));
		TS_TRY(header(t, sim));
	}
	if (first || (c->step == c->last_step && !sim->in_pieces) || sim->stop || (t->every && c->step % t->every == 0))
		TS_TRY(row(t, sim));
	if (sim->log.progress || sim->log.sink)
		progress(t, sim);
	return TS_OK;
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
	ts_str_release(&t->line);
	ts_arena_release(&t->arena);
}

const struct ts_system_style ts_thermo_system = {
	.style = {
		.name = "thermo",
		.kind = TS_KIND_SYSTEM,
		.summary = "Table of numbers in the log, progress line",
		.state_size = sizeof(struct ts_thermo),
		.init = init,
		.plan = plan,
		.hook = {
			[TS_STAGE_OUTPUT] = output,
			[TS_STAGE_FINISH] = finish,
		},
		.fini = fini,
	},
	.slot = offsetof(struct tsim, thermo),
	.keywords = ts_thermo_keywords,
};
