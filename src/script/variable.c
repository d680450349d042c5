#include "script/variable.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "script/interpreter.h"

#include "base/banned.h"

const char *const ts_variable_styles[] = { "index", "loop", "string", "getenv",
					   "equal", "atom", NULL };

struct ts_variable *ts_variable_find(const struct ts_script *script, const char *name)
{
	for (size_t k = 0; k < script->variables.n; k++)
		if (ts_streq(script->variables.item[k]->name, name))
			return script->variables.item[k];
	return NULL;
}

enum ts_status ts_variable_require(struct ts_script *script, const char *name,
				   const struct ts_place *where, struct ts_variable **out)
{
	struct ts_suggest suggest = ts_suggest_start(name);

	*out = ts_variable_find(script, name);
	if (*out) {
		(*out)->used = true;
		return TS_OK;
	}
	for (size_t k = 0; k < script->variables.n; k++)
		ts_suggest_try(&suggest, script->variables.item[k]->name);
	return ts_fail(&script->sim->error, TS_UNKNOWN, where, "unknown variable '%s'%s", name,
		       ts_suggest_text(&suggest));
}

static void release(struct ts_variable *variable)
{
	ts_arena_release(&variable->arena);
	ts_free(variable);
}

void ts_variable_delete(struct ts_script *script, struct ts_variable *variable)
{
	struct ts_variables *all = &script->variables;
	size_t k = 0;

	while (k < all->n && all->item[k] != variable)
		k++;
	if (k == all->n)
		return;
	release(variable);
	all->n--;
	for (; k < all->n; k++)
		all->item[k] = all->item[k + 1];
}

void ts_variables_release(struct ts_script *script)
{
	for (size_t k = 0; k < script->variables.n; k++)
		release(script->variables.item[k]);
	ts_free(script->variables.item);
	script->variables = (struct ts_variables){ 0 };
}

static enum ts_status check_name(struct ts_error *error, const struct ts_word *name)
{
	bool good = name->text[0] != '\0';

	for (const char *c = name->text; *c; c++)
		good &= isalnum((unsigned char)*c) || *c == '_';
	if (good)
		return TS_OK;
	return ts_fail(error, TS_SYNTAX, &name->place,
		       "a variable's name is made of letters, digits and _, found '%s'",
		       name->text);
}

/* loop N | loop N1 N2 [pad] */
static enum ts_status read_loop(struct ts_error *error, struct ts_variable *variable)
{
	struct ts_words values = variable->values;
	int64_t bound[2] = { 1, 0 };

	if (values.n == 3 && ts_streq(values.word[2].text, "pad")) {
		variable->pad = (int)strlen(values.word[1].text);
	} else if (values.n == 2 && ts_streq(values.word[1].text, "pad")) {
		variable->pad = (int)strlen(values.word[0].text);
		values.n = 1;
	} else if (values.n != 1 && values.n != 2) {
		return ts_fail(error, TS_SYNTAX, &variable->where,
			       "a loop variable takes 'N', 'N1 N2' or 'N1 N2 pad', found %zu words",
			       values.n);
	}
	for (size_t k = 0; k < 2 && k < values.n; k++)
		if (!ts_parse_int(values.word[k].text, &bound[values.n == 1 ? 1 : k]))
			return ts_fail(error, TS_SYNTAX, &values.word[k].place,
				       "expected a whole number, found '%s'", values.word[k].text);
	if (bound[1] < bound[0])
		return ts_fail(error, TS_RANGE, &values.word[0].place,
			       "the loop from %" PRId64 " to %" PRId64 " has no values", bound[0],
			       bound[1]);
	variable->at = bound[0];
	variable->last = bound[1];
	return TS_OK;
}

static enum ts_status read_values(struct ts_script *script, struct ts_variable *variable,
				  struct ts_words values)
{
	struct ts_error *error = &script->sim->error;
	const char *style = ts_variable_styles[variable->style];

	if (values.n == 0)
		return ts_fail(error, TS_SYNTAX, &variable->where,
			       "a variable of style %s needs a value", style);
	if (ts_words_copy(&variable->arena, values, &variable->values) != TS_OK)
		return ts_nomem(error);
	variable->last = (int64_t)values.n - 1;
	if (variable->style == TS_VAR_LOOP)
		return read_loop(error, variable);
	if (variable->style != TS_VAR_INDEX && values.n > 1)
		return ts_fail(error, TS_SYNTAX, &values.word[1].place,
			       "a variable of style %s takes one word; put quotes around a value "
			       "with blanks",
			       style);
	return TS_OK;
}

enum ts_status ts_variable_define(struct ts_script *script, const struct ts_word *name,
				  enum ts_variable_style style, struct ts_words values)
{
	struct ts_variables *all = &script->variables;
	struct ts_error *error = &script->sim->error;
	struct ts_variable *old = ts_variable_find(script, name->text), *made;
	enum ts_status status;

	TS_TRY(check_name(error, name));
	if (old && (style == TS_VAR_INDEX || style == TS_VAR_LOOP))
		return TS_OK;
	if (old && old->style != style)
		return ts_fail(error, TS_STATE, &name->place,
			       "variable '%s' exists with style %s (%s:%d); 'variable %s delete' "
			       "first, or declare it here with style index",
			       name->text, ts_variable_styles[old->style], old->where.file,
			       old->where.line, name->text);
	if (old && old->busy)
		return ts_fail(error, TS_STATE, &name->place,
			       "variable '%s' cannot change while it is evaluated", name->text);
	if (TS_GROW(all->item, all->capacity, all->n + 1) != TS_OK)
		return ts_nomem(error);
	made = ts_alloc(1, sizeof *made);
	if (!made)
		return ts_nomem(error);
	made->style = style;
	made->where = name->place;
	made->name = ts_arena_strdup(&made->arena, name->text);
	status = made->name ? read_values(script, made, values) : ts_nomem(error);
	if (status != TS_OK) {
		release(made);
		return status;
	}
	made->used = old && old->used;
	if (old)
		ts_variable_delete(script, old);
	all->item[all->n++] = made;
	return TS_OK;
}

enum ts_status ts_variable_text(struct ts_script *script, struct ts_variable *variable,
				const struct ts_place *where, struct ts_str *out)
{
	struct ts_error *error = &script->sim->error;
	const char *text;
	double value;

	switch (variable->style) {
	case TS_VAR_INDEX:
	case TS_VAR_STRING:
		ts_str_add(out, variable->values.word[variable->at].text);
		break;
	case TS_VAR_LOOP:
		ts_str_addf(out, "%0*" PRId64, variable->pad, variable->at);
		break;
	case TS_VAR_GETENV:
		text = getenv(variable->values.word[0].text);
		if (!text)
			return ts_fail(
				error, TS_UNKNOWN, where,
				"the environment has no '%s', which variable '%s' stands for",
				variable->values.word[0].text, variable->name);
		ts_str_add(out, text);
		break;
	case TS_VAR_EQUAL:
		TS_TRY(ts_variable_number(script, variable, where, &value));
		ts_str_addf(out, "%.15g", value);
		break;
	case TS_VAR_ATOM:
		return ts_fail(error, TS_STATE, where,
			       "variable '%s' has a value for each particle and cannot be put into "
			       "a line",
			       variable->name);
	}
	return out->failed ? ts_nomem(error) : TS_OK;
}

static enum ts_status enter(struct ts_script *script, struct ts_variable *variable,
			    const struct ts_place *where)
{
	if (variable->busy)
		return ts_fail(&script->sim->error, TS_STATE, where,
			       "the formula of variable '%s' uses itself", variable->name);
	variable->busy = true;
	return TS_OK;
}

/* Says who asked for a formula that failed, if that is not plain from the place. */
static void leave(struct ts_script *script, struct ts_variable *variable, enum ts_status status,
		  const struct ts_place *where)
{
	struct ts_error *error = &script->sim->error;
	size_t n = strlen(error->message);

	variable->busy = false;
	if (status == TS_OK || status == TS_NOMEM || !where || !where->line ||
	    strstr(error->message, " (variable ") ||
	    (error->place.line == where->line && ts_streq(error->place.file, where->file)))
		return;
	snprintf(error->message + n, sizeof error->message - n, " (variable '%s', needed by %s:%d)",
		 variable->name, where->file, where->line);
}

enum ts_status ts_variable_number(struct ts_script *script, struct ts_variable *variable,
				  const struct ts_place *where, double *out)
{
	struct ts_error *error = &script->sim->error;
	struct ts_str text = { 0 };
	enum ts_status status;

	if (variable->style == TS_VAR_EQUAL) {
		const struct ts_word *formula = &variable->values.word[0];

		TS_TRY(enter(script, variable, where));
		status = ts_expr_scalar(script, formula->text, &formula->place, out);
		leave(script, variable, status, where);
		return status;
	}
	if (variable->style == TS_VAR_ATOM)
		return ts_fail(error, TS_STATE, where,
			       "variable '%s' has a value for each particle; one number is needed "
			       "here",
			       variable->name);
	status = ts_variable_text(script, variable, where, &text);
	if (status == TS_OK && !ts_parse_real(ts_str_text(&text), out))
		status = ts_fail(error, TS_SYNTAX, where,
				 "variable '%s' is '%s', which is no number", variable->name,
				 ts_str_text(&text));
	ts_str_release(&text);
	return status;
}

enum ts_status ts_variable_peratom(struct ts_script *script, struct ts_variable *variable,
				   const struct ts_place *where, struct ts_table *out)
{
	const struct ts_word *formula = &variable->values.word[0];
	enum ts_status status;

	if (variable->style != TS_VAR_ATOM && variable->style != TS_VAR_EQUAL)
		return ts_fail(&script->sim->error, TS_STATE, where,
			       "variable '%s' is of style %s; values for each particle need style "
			       "atom",
			       variable->name, ts_variable_styles[variable->style]);
	TS_TRY(enter(script, variable, where));
	status = ts_expr_peratom(script, formula->text, &formula->place, out);
	leave(script, variable, status, where);
	return status;
}

enum ts_status ts_variable_next(struct ts_script *script, struct ts_variable *variable,
				const struct ts_place *where, bool *exhausted)
{
	if (variable->style != TS_VAR_INDEX && variable->style != TS_VAR_LOOP)
		return ts_fail(&script->sim->error, TS_STATE, where,
			       "'next' needs an index or loop variable; '%s' is of style %s",
			       variable->name, ts_variable_styles[variable->style]);
	*exhausted = variable->at == variable->last;
	variable->at += !*exhausted;
	return TS_OK;
}
