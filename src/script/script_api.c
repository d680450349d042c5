/* The functions of struct ts_script_api (core/script_api.h), by which the core and the styles use the script
 * interpreter. */
#include <assert.h>

#include "formula/dry_run.h"
#include "formula/unknown.h"
#include "script/check.h"

#include "base/banned.h"

static enum ts_status api_execute(void *data, const char *text, const struct ts_place *where)
{
	return ts_script_execute(data, text, where);
}

static bool api_has_quit(void *data)
{
	return ((const struct ts_script *)data)->quit;
}

static enum ts_status api_substitute(void *data, const char *text, const struct ts_place *where,
				     struct ts_str *out)
{
	return ts_substitute_text(data, text, where, out);
}

static struct ts_formulas *get_formulas(void *data)
{
	return &((struct ts_script *)data)->formulas;
}

/* The rest of the program gets 1 for an unknown value, and -check leaves out errors that may follow from
 * it. */
static double replace_unknown(struct ts_script *script, double value)
{
	if (!ts_unknown(script->sim, value))
		return value;
	if (script->check)
		script->check->guesses = true;
	return 1;
}

static enum ts_status api_scalar(void *data, const char *name, const struct ts_place *where, double *out)
{
	struct ts_variable *variable;

	TS_TRY(ts_variable_require(get_formulas(data), name, where, &variable));
	TS_TRY(ts_variable_number(get_formulas(data), variable, where, out));
	*out = replace_unknown(data, *out);
	return TS_OK;
}

static enum ts_status replace_unknown_values(struct ts_script *script, struct ts_table *table)
{
	for (size_t k = 0; script->sim->reading.explain && k < table->rows; k++)
		table->data[k] = replace_unknown(script, table->data[k]);
	return TS_OK;
}

static enum ts_status api_peratom(void *data, const char *name, const struct ts_place *where,
				  struct ts_table *out)
{
	struct ts_variable *variable;

	TS_TRY(ts_variable_require(get_formulas(data), name, where, &variable));
	TS_TRY(ts_variable_peratom(get_formulas(data), variable, where, out));
	return replace_unknown_values(data, out);
}

static bool api_has_variable(void *data, const char *name)
{
	return ts_variable_find(get_formulas(data), name) != NULL;
}

static bool api_is_peratom(void *data, const char *name)
{
	const struct ts_variable *variable = ts_variable_find(get_formulas(data), name);

	return variable && variable->style->peratom && !variable->style->number;
}

static bool api_is_vector(void *data, const char *name)
{
	const struct ts_variable *variable = ts_variable_find(get_formulas(data), name);

	return variable && variable->style->vector;
}

static enum ts_status api_vector(void *data, const char *name, const struct ts_place *where,
				 struct ts_table *out)
{
	struct ts_variable *variable;

	TS_TRY(ts_variable_require(get_formulas(data), name, where, &variable));
	TS_TRY(ts_variable_vector(get_formulas(data), variable, where, out));
	return replace_unknown_values(data, out);
}

static enum ts_status api_check_variable(void *data, const char *name, enum ts_shape shape,
					 const struct ts_place *where)
{
	struct ts_dry_run before = ts_dry_run_begin(get_formulas(data));
	struct ts_table table = { 0 };
	struct ts_variable *variable;
	enum ts_status status = ts_variable_require(get_formulas(data), name, where, &variable);
	double number;

	if (status == TS_OK && shape == TS_PERATOM && variable->style->peratom)
		status = ts_variable_peratom(get_formulas(data), variable, where, &table);
	else if (status == TS_OK && shape == TS_VECTOR)
		status = ts_variable_vector(get_formulas(data), variable, where, &table);
	else if (status == TS_OK)
		status = ts_variable_number(get_formulas(data), variable, where, &number);
	ts_table_release(&table);
	return ts_dry_run_end(get_formulas(data), before, status, true);
}

/* Notes what the formula of a variable, and those that it uses, read. */
static void note_reads(void *data, const char *name)
{
	struct ts_formulas *formulas = get_formulas(data);
	enum ts_shape shape = api_is_peratom(data, name)  ? TS_PERATOM
			      : api_is_vector(data, name) ? TS_VECTOR
							  : TS_SCALAR;

	formulas->reads_all = formulas->reads_fluid = false;
	if (api_check_variable(data, name, shape, NULL) != TS_OK)
		ts_error_clear(&formulas->sim->error); /* whoever evaluates it says so */
}

static bool api_reads_all(void *data, const char *name)
{
	note_reads(data, name);
	return get_formulas(data)->reads_all;
}

static bool api_reads_fluid(void *data, const char *name)
{
	note_reads(data, name);
	return get_formulas(data)->reads_fluid;
}

static bool api_words_of_variable(void *data, const char *name, struct ts_words *out)
{
	const struct ts_variable *variable = ts_variable_find(get_formulas(data), name);

	if (variable)
		*out = variable->values;
	return variable != NULL;
}

static enum ts_status api_check_commands(void *data, struct ts_words commands)
{
	return ts_later_check_commands(data, commands);
}

static enum ts_status api_check_text(void *data, const char *text, const struct ts_place *where)
{
	return ts_later_check_text(data, text, where);
}

static void api_expect_commands(void *data, struct ts_words commands)
{
	struct ts_script *script = data;

	script->expected = commands;
}

static enum ts_status require_internal(struct ts_formulas *formulas, const char *name,
				       const struct ts_place *where, struct ts_variable **out)
{
	TS_TRY(ts_variable_require(formulas, name, where, out));
	if ((*out)->style != &ts_var_internal)
		return ts_fail(&formulas->sim->error, TS_STATE, where,
			       "variable '%s' is of style %s; one of style internal is needed here", name,
			       (*out)->style->name);
	return TS_OK;
}

static enum ts_status api_columns(void *data, const char *name, const struct ts_place *where,
				  const struct ts_script_rows *set, size_t nset, size_t n, double *out)
{
	struct ts_variable_rows rows[TS_SCRIPT_ROWS] = { { .row = NULL } };
	struct ts_variable *variable;

	TS_TRY(ts_variable_require(get_formulas(data), name, where, &variable));
	assert(nset <= TS_SCRIPT_ROWS);
	for (size_t k = 0; k < nset; k++) {
		rows[k].row = set[k].row;
		TS_TRY(require_internal(get_formulas(data), set[k].internal, where, &rows[k].internal));
	}
	TS_TRY(ts_variable_columns(get_formulas(data), variable, where, rows, nset, n, out));
	for (size_t k = 0; k < n; k++)
		out[k] = replace_unknown(data, out[k]);
	return TS_OK;
}

static enum ts_status api_set(void *data, const char *name, const struct ts_place *where, double value)
{
	struct ts_script *script = data;
	struct ts_variable *variable;

	TS_TRY(require_internal(&script->formulas, name, where, &variable));
	variable->number = value;
	script->formulas.evaluation++; /* values computed with the old number are void */
	return TS_OK;
}

static enum ts_status api_archive(void *data, struct ts_archive *archive)
{
	return ts_formulas_archive(get_formulas(data), archive);
}

static void api_suggest_variable(void *data, struct ts_suggest *suggest)
{
	const struct ts_script *script = data;

	ts_variables_compact(get_formulas(data));
	for (size_t k = 0; k < script->formulas.variables.n; k++)
		ts_suggest_try(suggest, script->formulas.variables.item[k]->name);
}

/* "  k, equal, 2*b, in.script:7"; variables that step through a list also show their present value. */
static enum ts_status api_list_variables(void *data, struct ts_str *out)
{
	struct ts_script *script = data;

	ts_variables_compact(&script->formulas);
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

/* The k-th script that is being read, the outermost first; NULL: there are fewer. */
static const struct ts_source *get_source(const struct ts_script *script, size_t k)
{
	const struct ts_source *source = script->source;
	size_t n = 0;

	for (const struct ts_source *s = source; s; s = s->outer)
		n++;
	if (k >= n)
		return NULL;
	for (n -= k + 1; n; n--)
		source = source->outer;
	return source;
}

/* Scripts being read, from the outermost on, then those that have ended, from the last one back. */
static const char *api_script_text(void *data, size_t k, const char **name)
{
	const struct ts_script *script = data;
	const struct ts_source *source = get_source(script, k);
	size_t active = 0;

	if (source) {
		*name = source->name;
		return ts_str_text(&source->text);
	}
	while (get_source(script, active))
		active++;
	for (const struct ts_script_text *t = script->text; t; t = t->next)
		if (active++ == k) {
			*name = t->name;
			return t->text;
		}
	return NULL;
}

static enum ts_status api_defer_error(void *data, enum ts_status status)
{
	return ts_check_defer_error(data, status);
}

static enum ts_status api_planned(void *data, const struct ts_place *where, int64_t steps)
{
	const struct ts_script *script = data;

	if (script->check)
		return ts_check_record_run(data, where, steps);
	script->sim->reading.planned = true;
	return TS_OK;
}

static enum ts_status api_would_write(void *data, const struct ts_place *where, const char *what,
				      const char *path)
{
	const struct ts_script *script = data;

	return script->check ? ts_check_record_write(data, where, what, path) : TS_OK;
}

const struct ts_script_api ts_script_api_table = {
	.execute = api_execute,
	.has_quit = api_has_quit,
	.substitute = api_substitute,
	.scalar = api_scalar,
	.peratom = api_peratom,
	.has_variable = api_has_variable,
	.vector = api_vector,
	.is_peratom = api_is_peratom,
	.is_vector = api_is_vector,
	.set = api_set,
	.columns = api_columns,
	.check_variable = api_check_variable,
	.reads_all = api_reads_all,
	.reads_fluid = api_reads_fluid,
	.words_of_variable = api_words_of_variable,
	.check_commands = api_check_commands,
	.check_text = api_check_text,
	.expect_commands = api_expect_commands,
	.archive = api_archive,
	.list_variables = api_list_variables,
	.suggest_variable = api_suggest_variable,
	.script_text = api_script_text,
	.defer_error = api_defer_error,
	.planned = api_planned,
	.would_write = api_would_write,
};
