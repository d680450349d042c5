/* Fix print: prints a line of text every N steps. */
#include "core/report.h"
#include "core/sim.h"
#include "io/csv.h"
#include "io/last_step.h"

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

static enum ts_status check_title(struct ts_instance *self, struct tsim *sim);

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	TS_TRY(ts_textfile_choose(&sim->error, &self->where, self->style->name, s->file, s->append));
	return check_title(self, sim);
}

/* Adds the text with the values of its variables. */
static enum ts_status substitute(struct ts_instance *self, struct tsim *sim, const char *text,
				 struct ts_str *out)
{
	const struct state *s = self->state;

	if (sim->script_api)
		return sim->script_api->substitute(sim->script_api_data, text,
						   ts_instance_word(self, s->text), out);
	ts_str_add(out, text);
	return TS_OK;
}

/* The length of the part of a text up to a comma or blank that is not within brackets or quotes, such as that of
 * $(mass(all) + 1). */
static size_t part_length(const char *text)
{
	int depth = 0;
	size_t n = 0;

	for (; text[n] && (depth > 0 || !strchr(" \t,", text[n])); n++) {
		depth += text[n] == '(' || text[n] == '{' || text[n] == '[';
		depth -= text[n] == ')' || text[n] == '}' || text[n] == ']';
	}
	return n;
}

/* The name of the column of a part: NAME of ${NAME} and $(NAME). */
static void add_name(const char *part, size_t n, struct ts_str *row)
{
	bool bracketed = n > 3 && part[0] == '$' && strchr("({", part[1]);
	struct ts_str name = { 0 };

	if (bracketed)
		ts_str_add_n(&name, part + 2, n - 3);
	else
		ts_str_add_n(&name, part, n);
	ts_csv_text(row, ts_str_text(&name));
	row->failed |= name.failed;
	ts_str_release(&name);
}

/* Adds the value of a part, with its variables, to the row and to the line. */
static enum ts_status add_value(struct ts_instance *self, struct tsim *sim, const char *part, size_t n,
				struct ts_str *row)
{
	struct state *s = self->state;
	struct ts_str text = { 0 }, value = { 0 };
	enum ts_status status;

	ts_str_add_n(&text, part, n);
	status = substitute(self, sim, ts_str_text(&text), &value);
	ts_csv_text(row, ts_str_text(&value));
	ts_str_add(&s->line, ts_str_text(&value));
	row->failed |= text.failed || value.failed;
	ts_str_release(&text);
	ts_str_release(&value);
	return status;
}

/* The length of what separates two parts: blanks, and one comma. */
static size_t gap_length(const char *text)
{
	size_t n = strspn(text, " \t");

	return text[n] == ',' ? n + 1 + strspn(text + n + 1, " \t") : n;
}

/* Makes a row of the parts of a text: of their names, or of their values, with which the line is made, too. */
static enum ts_status make_row(struct ts_instance *self, struct tsim *sim, const char *text, bool names,
			       struct ts_str *row, int *count)
{
	struct state *s = self->state;

	*count = 0;
	text += strspn(text, " \t");
	while (*text) {
		size_t n = part_length(text), gap = gap_length(text + n);

		if (names)
			add_name(text, n, row);
		else
			TS_TRY(add_value(self, sim, text, n, row));
		if (!names)
			ts_str_add_n(&s->line, text + n, gap);
		text += n + gap;
		++*count;
	}
	ts_csv_end(row);
	return row->failed ? ts_nomem(&sim->error) : TS_OK;
}

static bool is_table(const struct state *s)
{
	return ts_csv_is(s->file ? s->file : s->append);
}

/* `title` names the columns of a table; default: the text as it is written in the script. */
static enum ts_status begin_table(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const char *names = s->title && !ts_streq(s->title, "none") ? s->title : s->text;
	struct ts_str row = { 0 };
	int ignored;
	enum ts_status status = make_row(self, sim, names, true, &row, &ignored);

	if (status == TS_OK)
		return ts_csv_begin(&s->out, sim, &row);
	ts_str_release(&row);
	return status;
}

static enum ts_status check_title(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	struct ts_str row = { 0 };
	int names = 0, parts = 0;

	if (!is_table(s) || !s->title || ts_streq(s->title, "none"))
		return TS_OK;
	TS_TRY(make_row(self, sim, s->title, true, &row, &names));
	TS_TRY(make_row(self, sim, s->text, true, &row, &parts));
	ts_str_release(&row);
	if (names == parts)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, s->title),
		       "fix print: the title names %d columns, but the text has %d parts, separated by "
		       "blanks or commas",
		       names, parts);
}

/* `line`: the first one to be written. */
static enum ts_status open_file(struct ts_instance *self, struct tsim *sim, const char *line)
{
	struct state *s = self->state;
	const char *path = s->file ? s->file : s->append;

	if (!path || ts_textfile_is_open(&s->out))
		return TS_OK;
	TS_TRY(ts_textfile_open(&s->out, sim, ts_instance_word(self, path), path, s->append != NULL));
	if (ts_last_step_begins(line, sim->clock.step))
		ts_last_step_warn(&s->out, sim, TS_STEP_ROWS, sim->clock.step);
	if (is_table(s))
		return begin_table(self, sim);
	if (!s->title)
		return ts_textfile_printf(&s->out, "# Fix print output for fix %s\n", self->id);
	if (ts_streq(s->title, "none"))
		return TS_OK;
	return ts_textfile_printf(&s->out, "%s\n", s->title);
}

static enum ts_status make_line(struct ts_instance *self, struct tsim *sim, struct ts_str *row)
{
	struct state *s = self->state;
	int ignored;

	ts_str_clear(&s->line);
	TS_TRY(is_table(s) ? make_row(self, sim, s->text, false, row, &ignored)
			   : substitute(self, sim, s->text, &s->line));
	return s->line.failed ? ts_nomem(&sim->error) : TS_OK;
}

static enum ts_status write_line(struct ts_instance *self, struct tsim *sim, struct ts_str *row)
{
	struct state *s = self->state;

	TS_TRY(make_line(self, sim, row));
	if (s->screen)
		ts_log(&sim->log, "%s\n", ts_str_text(&s->line));
	TS_TRY(open_file(self, sim, ts_str_text(is_table(s) ? row : &s->line)));
	if (!ts_textfile_is_open(&s->out))
		return TS_OK;
	if (is_table(s))
		return ts_csv_write(&s->out, sim, row);
	TS_TRY(ts_textfile_printf(&s->out, "%s\n", ts_str_text(&s->line)));
	return ts_textfile_flush(&s->out);
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	struct ts_str row = { 0 };
	enum ts_status status;

	if (sim->clock.step % s->every != 0)
		return TS_OK;
	status = write_line(self, sim, &row);
	ts_str_release(&row);
	return status;
}

/* LAMMPS also prints where a run begins. */
static enum ts_status set_up(struct ts_instance *self, struct tsim *sim)
{
	return sim->legacy == TS_LEGACY_LAMMPS ? end_of_step(self, sim) : TS_OK;
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

static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return sim->clock.step % s->every == 0;
}

TS_STYLE(fix, ts_style, ts_fix_print)
const struct ts_style ts_fix_print = {
	.name = "print",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
	.due = due,
	.summary = "Prints a line of text every N steps",
	.doc = "Prints the line at the end of each step that is a multiple of N; ${name} and $(formula) in "
	       "it are replaced by their current values. Before the first step of a run they are checked: "
	       "variables, computes and fixes must exist and have values of the right shape. With `legacy "
	       "lammps` a line is also printed where a run begins, if its step is a multiple of N.\n\n"
	       "A file whose name ends in .csv is a table of comma-separated values: the parts of the text, "
	       "separated by blanks or commas, are its columns, and the first line has their names: those of "
	       "`title`, else `name` for ${name} and `formula` for $(formula). An appended table has one "
	       "line of names.",
	.example = "fix depth all print 1000 \"$(step) ${depth}\" file post/depth.txt screen no",
	.args = args,
	.state_size = sizeof(struct state),
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_SETUP] = set_up,
	.hook[TS_STAGE_END_OF_STEP] = end_of_step,
	.fini = fini,
};
