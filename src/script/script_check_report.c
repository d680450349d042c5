/* The report of -check: what the script does and would write, lines never reached, errors. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "script/check.h"

#include "base/banned.h"

static void append_place(struct ts_str *out, const struct ts_place *where)
{
	char place[64];

	snprintf(place, sizeof place, "%s:%d", where->file ? where->file : "", where->line);
	ts_str_addf(out, "  %-20s ", where->line ? place : "");
}

static void append_count(struct ts_str *out, const char *before, int64_t n, const char *what)
{
	ts_str_addf(out, "%s%" PRId64 " %s%s", before, n, what, n == 1 ? "" : "s");
}

/* The innermost loop around the place with an unknown number of iterations. */
static const struct ts_check_loop *find_open_loop(const struct ts_check *check, const struct ts_place *where)
{
	const struct ts_check_loop *found = NULL;

	for (const struct ts_check_loop *l = check->loop; l; l = l->next)
		if (l->open && where->file && ts_streq(l->file, where->file) && l->from <= where->line &&
		    where->line <= l->to && (!found || l->from > found->from))
			found = l;
	return found;
}

static void append_run(const struct ts_check *check, const struct ts_check_event *e, struct ts_str *out)
{
	const struct ts_check_loop *loop = find_open_loop(check, &e->where);

	if (e->open) {
		ts_str_add(out, " a number of steps that is known only in a run, each");
	} else if (loop && e->count && e->steps % e->count == 0) {
		append_count(out, " ", e->steps / e->count, "step");
		ts_str_addf(out, " in each iteration of lines %d-%d,", loop->from, loop->to);
	} else {
		ts_str_add(out, loop ? " at least" : "");
		if (e->count > 1)
			append_count(out, " ", e->count, "time");
		append_count(out, e->count > 1 ? ", " : " ", e->steps, "step");
		ts_str_add(out, e->count > 1 ? " in all" : "");
	}
	ts_str_addf(out, " of %g from step %" PRId64 "%s", e->dt, e->step,
		    e->start_unknown ? " or later" : "");
	if (loop)
		ts_str_add(out, "; at least one iteration, their number is known only in a run");
}

static void append_jump(const struct ts_check_event *e, struct ts_str *out)
{
	if (e->iterations)
		ts_str_addf(out,
			    ": %" PRId64 " iterations; %" PRId64
			    " executed, the others counted like the last",
			    e->iterations, e->count + 1);
	else
		append_count(out, ": taken ", e->count, "time");
	if (e->bounded && !e->iterations)
		ts_str_addf(out, ", not followed further%s",
			    e->endless ? ": the loop seems to have no end" : "");
}

static void append_event(const struct ts_check *check, const struct ts_check_event *e, struct ts_str *out)
{
	append_place(out, &e->where);
	ts_str_add(out, e->what);
	if (e->kind == TS_CHECK_RUN) {
		append_run(check, e, out);
	} else if (strncmp(e->what, "jump", 4) == 0) {
		append_jump(e, out);
	} else if (e->count > 1) {
		append_count(out, ", ", e->count, "time");
	}
	if (e->depends_on)
		ts_str_addf(out, "; depends on %s, which is known only in a run", e->depends_on);
	ts_str_add(out, "\n");
}

/* Appends the events of the kinds from..to. */
static void append_events(const struct ts_check *check, enum ts_check_kind from, enum ts_check_kind to,
			  const char *title, struct ts_str *out)
{
	bool any = false;

	for (const struct ts_check_event *e = check->first; e; e = e->next) {
		if (e->kind < from || e->kind > to)
			continue;
		ts_str_add(out, any ? "" : title);
		any = true;
		append_event(check, e, out);
	}
}

/* Whether the line has a command, other than `label`, that was not executed. */
static bool is_unreached(struct ts_script *script, struct ts_line *line)
{
	struct ts_str key = { 0 };
	const char *text;
	bool reached;

	ts_line_uncomment(line);
	text = ts_str_text(&line->text);
	text += strspn(text, " \t");
	if (!*text || (strncmp(text, "label", 5) == 0 && strchr(" \t", text[5])))
		return false;
	ts_str_addf(&key, "%s:%d", line->row[0].file, line->row[0].line);
	reached = ts_map_get(&script->check->seen, ts_str_text(&key));
	ts_str_release(&key);
	return !reached;
}

static void append_line_range(struct ts_str *out, const char *name, int from, int to)
{
	if (from == to)
		ts_str_addf(out, "  %s:%d\n", name, from);
	else if (from)
		ts_str_addf(out, "  %s:%d-%d\n", name, from, to);
}

/* Appends the ranges of lines of a file that were not executed, and parses these for errors. */
static enum ts_status append_unreached_lines(struct ts_script *script, const struct ts_script_text *text,
					     struct ts_str *out)
{
	struct ts_line line = { 0 };
	struct ts_source source;
	enum ts_status status = ts_source_string(&source, script->sim, text->text, text->name);
	int from = 0, to = 0;
	bool end = false;

	while (status == TS_OK && !end) {
		status = ts_source_line(&source, script->sim, &line, &end);
		if (status != TS_OK || end)
			break;
		if (!is_unreached(script, &line))
			continue;
		if (from && line.row[0].line > to + 1) {
			append_line_range(out, text->name, from, to);
			from = 0;
		}
		from = from ? from : line.row[0].line;
		to = source.line;
		status = ts_check_unreached(script, &line, " (in a line that is never reached)");
	}
	if (from)
		append_line_range(out, text->name, from, to);
	ts_line_release(&line);
	ts_source_close(&source);
	return status;
}

enum ts_status ts_script_check_report(struct ts_script *script, struct ts_str *errors, struct ts_str *report,
				      int *nerrors)
{
	struct ts_check *check = script->check;
	struct ts_str unreached = { 0 };
	enum ts_status status = TS_OK;

	for (const struct ts_script_text *t = script->text; t && status == TS_OK; t = t->next)
		status = append_unreached_lines(script, t, &unreached);
	append_events(check, TS_CHECK_STEP, TS_CHECK_RUN, "what it does:\n", report);
	append_events(check, TS_CHECK_WRITE, TS_CHECK_WRITE, "what it would write or change:\n", report);
	if (unreached.length)
		ts_str_addf(report, "lines never reached:\n%s", ts_str_text(&unreached));
	ts_str_release(&unreached);
	ts_str_add(errors, ts_str_text(&check->errors));
	if (!check->nerrors)
		ts_str_add(report, "no errors");
	else
		append_count(report, "", check->nerrors, "error");
	ts_str_add(report, check->left_out ? "" : "\n");
	if (check->left_out)
		ts_str_addf(report, "; %d more message%s left out, since they may follow from these\n",
			    check->left_out, check->left_out == 1 ? " was" : "s were");
	if (check->open)
		ts_str_addf(report, "%d message%s on values known only in a run\n", check->open,
			    check->open == 1 ? " was left out that depends" : "s were left out that depend");
	*nerrors = check->nerrors;
	return status;
}
