/* Fix print: prints a line of text every N steps. */
#include "core/report.h"
#include "core/sim.h"
#include "io/textfile.h"

#include <string.h>

#include "base/banned.h"

struct state {
	int64_t every;
	const char *text;
	const char *file, *append, *title;
	bool screen;
	struct ts_textfile out;
	struct ts_str line;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	if (s->file && s->append)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix print: expected either file or append, found both");
	return TS_OK;
}

static enum ts_status open_file(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const char *path = s->file ? s->file : s->append;

	if (!path || ts_textfile_is_open(&s->out))
		return TS_OK;
	TS_TRY(ts_textfile_open(&s->out, sim, ts_instance_word(self, path), path, s->append != NULL));
	if (!s->title)
		return ts_textfile_printf(&s->out, "# Fix print output for fix %s\n", self->id);
	if (ts_streq(s->title, "none"))
		return TS_OK;
	return ts_textfile_printf(&s->out, "%s\n", s->title);
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (sim->clock.step % s->every != 0)
		return TS_OK;
	ts_str_clear(&s->line);
	if (sim->script_api)
		TS_TRY(sim->script_api->substitute(sim->script_api_data, s->text,
						   ts_instance_word(self, s->text), &s->line));
	else
		ts_str_add(&s->line, s->text);
	if (s->line.failed)
		return ts_nomem(&sim->error);
	if (s->screen)
		ts_log(&sim->log, "%s\n", ts_str_text(&s->line));
	TS_TRY(open_file(self, sim));
	if (!ts_textfile_is_open(&s->out))
		return TS_OK;
	TS_TRY(ts_textfile_printf(&s->out, "%s\n", ts_str_text(&s->line)));
	return ts_textfile_flush(&s->out);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;
	const char *path = s->file ? s->file : s->append;

	if (sim->script_api && !report->limits_only)
		TS_TRY(sim->script_api->check_text(sim->script_api_data, s->text,
						   ts_instance_word(self, s->text)));
	if (!sim->reading.explain || !path)
		return TS_OK;
	return ts_report_output(report, path, ts_report_count(sim, s->every), (double)strlen(s->text) + 1) ==
			       TS_OK
		       ? TS_OK
		       : ts_nomem(&sim->error);
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_textfile_close(&s->out);
	ts_str_release(&s->line);
}

static const struct ts_arg args[] = {
	TS_INT("every", struct state, every, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "steps between lines"),
	TS_WORD("text", struct state, text, .flags = TS_POSITIONAL,
		.help = "text in quotes; variables in it are substituted each time"),
	TS_WORD("file", struct state, file, .flags = TS_OPTIONAL | TS_WRITES,
		.help = "file to write; an existing one is replaced"),
	TS_WORD("append", struct state, append, .flags = TS_OPTIONAL | TS_WRITES,
		.help = "file to append to"),
	TS_BOOL("screen", struct state, screen, .fallback = "yes",
		.help = "whether the line is also written to the screen and the log"),
	TS_WORD("title", struct state, title, .flags = TS_OPTIONAL,
		.help = "first line of the file instead of '# Fix print output for fix ID'; none: no such "
			"line"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_print)
const struct ts_style ts_fix_print = {
	.name = "print",
	.kind = TS_KIND_FIX,
	.summary = "Prints a line of text every N steps",
	.doc = "Prints the line at the end of each step that is a multiple of N; ${name} and $(formula) in "
	       "it are replaced by their current values. Before the first step of a run they are checked: "
	       "variables, computes and fixes must exist and have values of the right shape.",
	.example = "fix depth all print 1000 \"$(step) ${depth}\" file post/depth.txt screen no",
	.args = args,
	.state_size = sizeof(struct state),
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_END_OF_STEP] = end_of_step,
	.fini = fini,
};
