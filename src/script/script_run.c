/* Execution of scripts, line by line. */
#include <string.h>

#include "core/life.h"
#include "core/saver.h"
#include "formula/unknown.h"
#include "script/check.h"

#include "base/banned.h"

enum { DEEPEST = 50 /* scripts and commands nested in each other */ };

const struct ts_place *ts_script_place(const struct ts_script *script, size_t k, const struct ts_place *where)
{
	return k < script->current.n ? &script->current.word[k].place : where;
}

enum ts_status ts_script_run_words(struct ts_script *script, struct ts_words words)
{
	struct ts_words outer = script->current;
	struct ts_error *error = &script->sim->error;
	enum ts_status status;

	script->current = words;
	status = ts_sim_command(script->sim, words);
	script->current = outer;
	if (status == TS_NOMEM) /* some callers return it without a message */
		ts_nomem(error);
	if (status != TS_OK && !error->place.line) {
		error->place = words.word[0].place;
		error->place.column = error->place.length = 0;
	}
	return status;
}

static enum ts_status begin_checked_line(struct ts_script *script, const struct ts_line *line)
{
	if (script->sim->reading.explain && !script->check)
		TS_TRY(ts_check_new(script));
	else if (!script->sim->reading.explain)
		ts_check_free(script);
	return script->check && line->rows ? ts_check_begin_line(script, &line->row[0]) : TS_OK;
}

/* -check: a warning of a line with guessed values, unless they are steps of a run, may follow from them. */
static enum ts_status run_words(struct ts_script *script, struct ts_words words, bool guessed)
{
	struct ts_log *log = &script->sim->log;
	bool outer = log->withholds;
	int before = log->withheld;
	enum ts_status status;

	log->withholds = guessed && !ts_script_command_runs(words.word[0].text);
	status = ts_script_run_words(script, words);
	if (log->withholds && script->check)
		script->check->open += log->withheld - before;
	log->withholds = outer;
	return status;
}

static enum ts_status run_line(struct ts_script *script, struct ts_line *line)
{
	struct ts_error *error = &script->sim->error;
	struct ts_arena arena = { 0 };
	struct ts_words words = { 0 };
	enum ts_status status;
	bool guessed;

	ts_log_echo(&script->sim->log, ts_str_text(&line->text));
	ts_line_uncomment(line);
	status = begin_checked_line(script, line);
	if (status == TS_OK)
		status = ts_substitute(script, line, true);
	if (status == TS_OK)
		status = ts_line_split(line, error, &arena, &words);
	guessed = status == TS_OK && words.n && script->check &&
		  ts_unknown_in_text(script->sim, ts_str_text(&line->text));
	if (guessed)
		status = ts_check_mark_guessed(script, line, words);
	if (status == TS_OK && words.n)
		status = run_words(script, words, guessed);
	if (status == TS_OK)
		status = ts_log_check(&script->sim->log, error);
	if (status == TS_OK && words.n)
		status = ts_saver_save(script->sim);
	script->sim->requests.stopped_whole |= status == TS_OK && script->sim->requests.stop;
	if (status == TS_OK && words.n && script->sim->requests.stop)
		status = ts_fail(error, TS_STOPPED, &words.word[0].place, "stopped on request");
	if (status != TS_OK && script->check)
		status = ts_check_recover(script, line, words, status);
	ts_arena_release(&arena);
	return status;
}

/* Searches a skipped line for labels; lines are executed again from the one at script->label on. */
static enum ts_status search_label(struct ts_script *script, struct ts_line *line)
{
	struct ts_arena arena = { 0 };
	struct ts_words words = { 0 };
	struct ts_error ignored = { 0 }; /* skipped lines may be wrong */
	enum ts_status status;

	ts_line_uncomment(line);
	status = ts_line_split(line, &ignored, &arena, &words);
	if (status == TS_OK && words.n == 2 && ts_streq(words.word[0].text, "label")) {
		status = ts_source_add_label(script->source, script->sim, words.word[1].text);
		if (ts_streq(words.word[1].text, script->label))
			script->label = NULL;
	}
	ts_arena_release(&arena);
	return status == TS_NOMEM ? ts_nomem(&script->sim->error) : TS_OK;
}

/* The script has ended before the label was found. -check continues behind the jump. */
static enum ts_status fail_no_label(struct ts_script *script)
{
	enum ts_status status = ts_fail(&script->sim->error, TS_UNKNOWN, &script->label_place,
					"there is no 'label %s' in %s", script->label, script->source->name);

	if (!script->sim->reading.check)
		return status;
	script->label = NULL;
	if (ts_streq(script->label_place.file, script->source->name))
		ts_source_set_position(script->source, script->check->at, script->check->line);
	return ts_check_keep_error(script, "");
}

static enum ts_status run_lines(struct ts_script *script)
{
	struct ts_line line = { 0 };
	enum ts_status status = TS_OK;
	bool end = false;

	while (status == TS_OK && !script->quit) {
		status = ts_source_line(script->source, script->sim, &line, &end);
		if (status != TS_OK || (end && !script->label))
			break;
		if (end)
			status = fail_no_label(script);
		else
			status = script->label ? search_label(script, &line) : run_line(script, &line);
	}
	ts_line_release(&line);
	return status;
}

static bool is_stored(const struct ts_script *script, const char *name)
{
	for (const struct ts_script_text *text = script->text; text; text = text->next)
		if (ts_streq(text->name, name))
			return true;
	return false;
}

static enum ts_status store_text(struct ts_script *script, struct ts_source *source, bool whole)
{
	struct ts_script_text *text;

	if (!source->stream || is_stored(script, source->name))
		return TS_OK;
	if (whole)
		TS_TRY(ts_source_read_all(source, script->sim));
	text = ts_arena_alloc(&script->arena, 1, sizeof *text);
	if (!text)
		return ts_nomem(&script->sim->error);
	text->name = source->name;
	text->included = source->outer != NULL;
	text->text = ts_arena_strdup(&script->arena, ts_str_text(&source->text));
	if (!text->text)
		return ts_nomem(&script->sim->error);
	text->next = script->text;
	script->text = text;
	return TS_OK;
}

enum ts_status ts_script_store_text(struct ts_script *script, struct ts_source *source)
{
	return store_text(script, source, source->owns_stream || script->sim->reading.check);
}

/* Executes the lines of the source and closes it. */
static enum ts_status run_source(struct ts_script *script, struct ts_source *source,
				 const struct ts_place *where)
{
	enum ts_status status;

	if (script->depth >= DEEPEST) {
		ts_source_close(source);
		return ts_fail(&script->sim->error, TS_RANGE, where,
			       "scripts include each other more than %d deep", DEEPEST);
	}
	script->depth++;
	source->outer = script->source;
	script->source = source;
	script->label = NULL;
	status = run_lines(script);
	if (status == TS_OK)
		status = ts_script_store_text(script, source);
	else /* for the report; the first error remains */
		store_text(script, source, source->owns_stream && status != TS_STOPPED);
	script->label = NULL;
	script->source = source->outer;
	script->depth--;
	ts_source_close(source);
	return status;
}

enum ts_status ts_script_include(struct ts_script *script, const char *path, const struct ts_place *where)
{
	struct ts_source source;

	TS_TRY(ts_source_open(&source, script->sim, path, where));
	return run_source(script, &source, where);
}

enum ts_status ts_script_file(struct ts_script *script, const char *path)
{
	return ts_script_include(script, path, NULL);
}

enum ts_status ts_script_stream(struct ts_script *script, FILE *stream, const char *name)
{
	struct ts_source source;

	TS_TRY(ts_source_stream(&source, script->sim, stream, name));
	return run_source(script, &source, NULL);
}

enum ts_status ts_script_string(struct ts_script *script, const char *text, const char *name)
{
	struct ts_source source;

	TS_TRY(ts_source_string(&source, script->sim, text, name));
	return run_source(script, &source, NULL);
}

enum ts_status ts_script_execute(struct ts_script *script, const char *text, const struct ts_place *where)
{
	struct ts_place nowhere = { 0 };
	struct ts_line line = { 0 };
	size_t length = strlen(text), at = 0, n;
	enum ts_status status = TS_OK;

	if (!where)
		where = &nowhere;
	if (script->depth >= DEEPEST)
		return ts_fail(&script->sim->error, TS_RANGE, where, "commands are nested more than %d deep",
			       DEEPEST);
	script->depth++;
	while (status == TS_OK && at < length && !script->quit && !script->label) {
		struct ts_place part;

		n = strcspn(text + at, "\n");
		part = n == length ? *where : ts_place_inside(where, length, at, n);
		if (ts_line_set(&line, text + at, n, &part) != TS_OK)
			status = ts_nomem(&script->sim->error);
		else
			status = run_line(script, &line);
		at += n + 1;
	}
	script->depth--;
	ts_line_release(&line);
	return status;
}
