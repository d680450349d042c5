#include "script/script.h"

#include <string.h>

#include "core/life.h"
#include "core/saver.h"
#include "script/check.h"
#include "formula/unknown.h"

#include "base/banned.h"

enum { DEEPEST = 50 };

static enum ts_status host_execute(void *host, const char *text, const struct ts_place *where)
{
	return ts_script_execute(host, text, where);
}

static enum ts_status host_substitute(void *host, const char *text, const struct ts_place *where,
				      struct ts_str *out)
{
	return ts_substitute_text(host, text, where, out);
}

static struct ts_formulas *formulas_of(void *host)
{
	return &((struct ts_script *)host)->formulas;
}

/* What the rest of the program gets for a value that is unknown: 1, and -check knows that the lines which use it
 * cannot be judged. */
static double guess_unknown(struct ts_script *script, double value)
{
	if (!ts_unknown(script->sim, value))
		return value;
	if (script->check)
		script->check->weak = true;
	return 1;
}

static enum ts_status host_scalar(void *host, const char *name, const struct ts_place *where, double *out)
{
	struct ts_variable *variable;

	TS_TRY(ts_variable_require(formulas_of(host), name, where, &variable));
	TS_TRY(ts_variable_number(formulas_of(host), variable, where, out));
	*out = guess_unknown(host, *out);
	return TS_OK;
}

static enum ts_status guess(struct ts_script *script, struct ts_table *table)
{
	for (size_t k = 0; script->sim->reading.explain && k < table->rows; k++)
		table->data[k] = guess_unknown(script, table->data[k]);
	return TS_OK;
}

static enum ts_status host_peratom(void *host, const char *name, const struct ts_place *where,
				   struct ts_table *out)
{
	struct ts_variable *variable;

	TS_TRY(ts_variable_require(formulas_of(host), name, where, &variable));
	TS_TRY(ts_variable_peratom(formulas_of(host), variable, where, out));
	return guess(host, out);
}

static bool host_has_variable(void *host, const char *name)
{
	return ts_variable_find(formulas_of(host), name) != NULL;
}

static bool host_is_peratom(void *host, const char *name)
{
	const struct ts_variable *variable = ts_variable_find(formulas_of(host), name);

	return variable && variable->style->peratom && !variable->style->number;
}

static bool host_is_vector(void *host, const char *name)
{
	const struct ts_variable *variable = ts_variable_find(formulas_of(host), name);

	return variable && variable->style->vector;
}

static enum ts_status host_vector(void *host, const char *name, const struct ts_place *where,
				  struct ts_table *out)
{
	struct ts_variable *variable;

	TS_TRY(ts_variable_require(formulas_of(host), name, where, &variable));
	TS_TRY(ts_variable_vector(formulas_of(host), variable, where, out));
	return guess(host, out);
}

static enum ts_status host_reads(void *host, const char *name, enum ts_shape shape,
				 const struct ts_place *where)
{
	struct ts_dry before = ts_dry_begin(formulas_of(host));
	struct ts_table table = { 0 };
	struct ts_variable *variable;
	enum ts_status status = ts_variable_require(formulas_of(host), name, where, &variable);
	double number;

	if (status == TS_OK && shape == TS_PERATOM && variable->style->peratom)
		status = ts_variable_peratom(formulas_of(host), variable, where, &table);
	else if (status == TS_OK && shape == TS_VECTOR)
		status = ts_variable_vector(formulas_of(host), variable, where, &table);
	else if (status == TS_OK && !variable->style->vector)
		status = ts_variable_number(formulas_of(host), variable, where, &number);
	ts_table_release(&table);
	return ts_dry_end(formulas_of(host), before, status, true);
}

static enum ts_status host_reads_commands(void *host, struct ts_words commands)
{
	return ts_later_commands(host, commands);
}

static enum ts_status host_reads_text(void *host, const char *text, const struct ts_place *where)
{
	return ts_later_text(host, text, where);
}

static void host_expects(void *host, struct ts_words commands)
{
	struct ts_script *script = host;

	script->expected = commands;
}

static enum ts_status host_set(void *host, const char *name, const struct ts_place *where, double value)
{
	struct ts_script *script = host;
	struct ts_variable *variable;

	TS_TRY(ts_variable_require(&script->formulas, name, where, &variable));
	if (variable->style != &ts_var_internal)
		return ts_fail(&script->sim->error, TS_STATE, where,
			       "variable '%s' is of style %s; one of style internal is needed here", name,
			       variable->style->name);
	variable->number = value;
	script->formulas.evaluation++; /* what was read with the number of before is of no use */
	return TS_OK;
}

static enum ts_status host_archive(void *host, struct ts_archive *archive)
{
	return ts_formulas_archive(formulas_of(host), archive);
}

static void host_suggest_variable(void *host, struct ts_suggest *suggest)
{
	const struct ts_script *script = host;

	ts_variables_pack(formulas_of(host));
	for (size_t k = 0; k < script->formulas.variables.n; k++)
		ts_suggest_try(suggest, script->formulas.variables.item[k]->name);
}

/* "  k, equal, 2*b, in.script:7"; lists say which value is theirs now. */
static enum ts_status host_list_variables(void *host, struct ts_str *out)
{
	struct ts_script *script = host;

	ts_variables_pack(&script->formulas);
	for (size_t k = 0; k < script->formulas.variables.n; k++) {
		struct ts_variable *v = script->formulas.variables.item[k];

		ts_str_addf(out, "  %s, %s,", v->name, v->style->name);
		for (size_t j = 0; j < v->values.n; j++)
			ts_str_addf(out, " %s", v->values.word[j].text);
		if (v->style->next && !v->feed) {
			ts_str_add(out, ", now ");
			TS_TRY(v->style->text(&script->formulas, v, &v->where, out));
		}
		if (v->where.file && v->where.line)
			ts_str_addf(out, ", %s:%d", v->where.file, v->where.line);
		ts_str_add(out, "\n");
	}
	return TS_OK;
}

static enum ts_status host_defer_error(void *host, enum ts_status status)
{
	return ts_check_defer_error(host, status);
}

static enum ts_status host_planned(void *host, const struct ts_place *where, int64_t steps)
{
	const struct ts_script *script = host;

	if (script->check)
		return ts_check_run(host, where, steps);
	script->sim->reading.planned = true;
	return TS_OK;
}

static enum ts_status host_would_write(void *host, const struct ts_place *where, const char *what,
				       const char *path)
{
	const struct ts_script *script = host;

	return script->check ? ts_check_write(host, where, what, path) : TS_OK;
}

static const struct ts_script_api host_table = {
	.execute = host_execute,
	.substitute = host_substitute,
	.scalar = host_scalar,
	.peratom = host_peratom,
	.has_variable = host_has_variable,
	.vector = host_vector,
	.is_peratom = host_is_peratom,
	.is_vector = host_is_vector,
	.set = host_set,
	.reads = host_reads,
	.reads_commands = host_reads_commands,
	.reads_text = host_reads_text,
	.expects = host_expects,
	.archive = host_archive,
	.list_variables = host_list_variables,
	.suggest_variable = host_suggest_variable,
	.defer_error = host_defer_error,
	.planned = host_planned,
	.would_write = host_would_write,
};

struct ts_script *ts_script_new(struct tsim *sim)
{
	struct ts_script *script = ts_alloc(1, sizeof *script);

	if (!script)
		return NULL;
	script->sim = script->formulas.sim = sim;
	sim->script_api = &host_table;
	sim->script_api_data = script;
	return script;
}

void ts_script_free(struct ts_script *script)
{
	if (!script)
		return;
	ts_formulas_release(&script->formulas);
	ts_check_free(script);
	ts_arena_release(&script->arena);
	script->sim->script_api = NULL;
	script->sim->script_api_data = NULL;
	ts_free(script);
}

enum ts_status ts_script_of(struct tsim *sim, const struct ts_place *where, struct ts_script **out)
{
	*out = sim->script_api == &host_table ? sim->script_api_data : NULL;
	if (*out)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, where, "this command works only in a script");
}

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
	if (status == TS_NOMEM) /* who only passes it on may have left no message */
		ts_nomem(error);
	if (status != TS_OK && !error->place.line) {
		error->place = words.word[0].place;
		error->place.column = error->place.length = 0;
	}
	return status;
}

static enum ts_status begin_line(struct ts_script *script, const struct ts_line *line)
{
	if (script->sim->reading.explain && !script->check)
		TS_TRY(ts_check_new(script));
	else if (!script->sim->reading.explain)
		ts_check_free(script);
	return script->check && line->rows ? ts_check_begin_line(script, &line->row[0]) : TS_OK;
}

static enum ts_status run_line(struct ts_script *script, struct ts_line *line)
{
	struct ts_error *error = &script->sim->error;
	struct ts_arena arena = { 0 };
	struct ts_words words = { 0 };
	enum ts_status status;

	ts_log_echo(&script->sim->log, ts_str_text(&line->text));
	ts_line_uncomment(line);
	status = begin_line(script, line);
	if (status == TS_OK)
		status = ts_substitute(script, line, true);
	if (status == TS_OK)
		status = ts_line_cut(line, error, &arena, &words);
	if (status == TS_OK && words.n && script->check &&
	    ts_unknown_text(script->sim, ts_str_text(&line->text)))
		status = ts_check_guess(script, line, words);
	if (status == TS_OK && words.n)
		status = ts_script_run_words(script, words);
	if (status == TS_OK)
		status = ts_log_check(&script->sim->log, error);
	if (status == TS_OK && words.n)
		status = ts_saver_act(script->sim);
	script->sim->requests.stopped_whole |= status == TS_OK && script->sim->requests.stop;
	if (status == TS_OK && words.n && script->sim->requests.stop)
		status = ts_fail(error, TS_STOPPED, &words.word[0].place, "stopped on request");
	if (status != TS_OK && script->check)
		status = ts_check_recover(script, line, words, status);
	ts_arena_release(&arena);
	return status;
}

/* A line that is skipped: does it carry the label that is looked for? */
static enum ts_status look_for_label(struct ts_script *script, struct ts_line *line)
{
	struct ts_arena arena = { 0 };
	struct ts_words words = { 0 };
	struct ts_error ignored = { 0 }; /* skipped lines may be wrong */
	enum ts_status status;

	ts_line_uncomment(line);
	status = ts_line_cut(line, &ignored, &arena, &words);
	if (status == TS_OK && words.n == 2 && ts_streq(words.word[0].text, "label")) {
		status = ts_source_mark(script->source, script->sim, words.word[1].text);
		if (ts_streq(words.word[1].text, script->label))
			script->label = NULL;
	}
	ts_arena_release(&arena);
	return status == TS_NOMEM ? ts_nomem(&script->sim->error) : TS_OK;
}

/* The end of the script came before the label. -check goes on behind the jump. */
static enum ts_status no_label(struct ts_script *script)
{
	enum ts_status status = ts_fail(&script->sim->error, TS_UNKNOWN, &script->label_place,
					"there is no 'label %s' in %s", script->label, script->source->name);

	if (!script->sim->reading.check)
		return status;
	script->label = NULL;
	if (ts_streq(script->label_place.file, script->source->name))
		ts_source_go(script->source, script->check->at, script->check->line);
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
			status = no_label(script);
		else
			status = script->label ? look_for_label(script, &line) : run_line(script, &line);
	}
	ts_line_release(&line);
	return status;
}

enum ts_status ts_script_keep(struct ts_script *script, struct ts_source *source)
{
	struct ts_script_text *text;

	if (!source->stream)
		return TS_OK;
	for (text = script->text; text; text = text->next)
		if (ts_streq(text->name, source->name))
			return TS_OK;
	if (source->owns_stream || script->sim->reading.check)
		TS_TRY(ts_source_rest(source, script->sim));
	text = ts_arena_alloc(&script->arena, 1, sizeof *text);
	if (!text)
		return ts_nomem(&script->sim->error);
	text->name = source->name;
	text->text = ts_arena_strdup(&script->arena, ts_str_text(&source->text));
	text->next = script->text;
	script->text = text;
	return text->text ? TS_OK : ts_nomem(&script->sim->error);
}

/* Runs and closes the source. */
static enum ts_status run_source(struct ts_script *script, struct ts_source *source,
				 const struct ts_place *where)
{
	struct ts_source *outer = script->source;
	enum ts_status status;

	if (script->depth >= DEEPEST) {
		ts_source_close(source);
		return ts_fail(&script->sim->error, TS_RANGE, where,
			       "scripts include each other more than %d deep", DEEPEST);
	}
	script->depth++;
	script->source = source;
	script->label = NULL;
	status = run_lines(script);
	if (status == TS_OK)
		status = ts_script_keep(script, source);
	script->label = NULL;
	script->source = outer;
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

enum ts_status ts_script_set(struct ts_script *script, const char *name, const char *const *values, size_t n,
			     const char *origin)
{
	struct ts_error *error = &script->sim->error;
	struct ts_arena arena = { 0 };
	struct ts_word *word = ts_arena_alloc(&arena, n + 1, sizeof *word);
	struct ts_variable *variable;
	enum ts_status status;

	if (!word)
		return ts_nomem(error);
	for (size_t k = 0; k <= n; k++) {
		word[k].text = k ? values[k - 1] : name;
		word[k].place.file = ts_pool_get(script->sim->pool, origin);
	}
	variable = ts_variable_find(&script->formulas, name);
	if (variable) /* the last one given wins */
		ts_variable_delete(&script->formulas, variable);
	status = ts_variable_define(&script->formulas, &word[0], &ts_var_index,
				    (struct ts_words){ word + 1, n });
	if (status == TS_OK)
		ts_variable_find(&script->formulas, name)->given = true;
	ts_arena_release(&arena);
	return status;
}

enum ts_status ts_script_define(struct ts_script *script, const char *name, const char *style,
				const char *value)
{
	const struct ts_word word[] = {
		{ .text = "variable" }, { .text = name }, { .text = style }, { .text = value }
	};
	struct ts_variable *old = ts_variable_find(&script->formulas, name);
	enum ts_status status;

	if (old && old->busy)
		return ts_fail(&script->sim->error, TS_STATE, NULL,
			       "variable '%s' cannot change while it is evaluated", name);
	if (old) /* hidden until the new one is there */
		ts_map_remove(&script->formulas.variables.by_name, old->name);
	status = ts_sim_command(script->sim, (struct ts_words){ word, value ? 4 : 3 });
	if (old && status == TS_OK)
		ts_variable_delete(&script->formulas, old);
	else if (old && ts_map_set(&script->formulas.variables.by_name, old->name, old) != TS_OK)
		return ts_nomem(&script->sim->error);
	return status;
}

const char *ts_script_variable(struct ts_script *script, size_t k)
{
	ts_variables_pack(&script->formulas);
	return k < script->formulas.variables.n ? script->formulas.variables.item[k]->name : NULL;
}

enum ts_status ts_script_value(struct ts_script *script, const char *expression, double *out)
{
	return ts_expr_scalar(&script->formulas, expression, NULL, out);
}

void ts_script_allow_programs(struct ts_script *script, bool allowed)
{
	script->programs = allowed;
}

bool ts_script_quit(const struct ts_script *script, int *status)
{
	*status = script->quit_status;
	return script->quit;
}
