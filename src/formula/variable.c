#include "formula/variable.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "formula/unknown.h"

#include "base/banned.h"

#define STYLE(style) &ts_var_##style,
const struct ts_variable_style *const ts_variable_styles[] = { TS_VARIABLE_STYLES(STYLE) NULL };
#undef STYLE

struct ts_variable *ts_variable_find(const struct ts_formulas *formulas, const char *name)
{
	return ts_map_get(&formulas->variables.by_name, name);
}

enum ts_status ts_variable_require(struct ts_formulas *formulas, const char *name,
				   const struct ts_place *where, struct ts_variable **out)
{
	struct ts_suggest suggest = ts_suggest_start(name);

	*out = ts_variable_find(formulas, name);
	if (*out) {
		(*out)->used = true;
		return TS_OK;
	}
	ts_variables_compact(formulas);
	for (size_t k = 0; k < formulas->variables.n; k++)
		ts_suggest_try(&suggest, formulas->variables.item[k]->name);
	return ts_missing(&formulas->sim->error, "variable", name, where, "unknown variable '%s'%s", name,
			  ts_suggest_text(&suggest));
}

static void release_variable(struct ts_variable *variable)
{
	if (variable->style->release)
		variable->style->release(variable);
	ts_arena_release(&variable->arena);
	ts_free(variable);
}

void ts_variable_delete(struct ts_formulas *formulas, struct ts_variable *variable)
{
	struct ts_variables *all = &formulas->variables;

	all->item[variable->place] = NULL;
	if (ts_variable_find(formulas, variable->name) == variable) /* not replaced by another */
		ts_map_remove(&all->by_name, variable->name);
	release_variable(variable);
	if (++all->deleted > all->n / 2)
		ts_variables_compact(formulas);
}

void ts_variables_compact(struct ts_formulas *formulas)
{
	struct ts_variables *all = &formulas->variables;
	size_t n = 0;

	for (size_t k = 0; k < all->n && all->deleted; k++) {
		if (!all->item[k])
			continue;
		all->item[k]->place = n;
		all->item[n++] = all->item[k];
	}
	if (all->deleted)
		all->n = n;
	all->deleted = 0;
}

void ts_variables_release(struct ts_formulas *formulas)
{
	ts_variables_compact(formulas);
	for (size_t k = 0; k < formulas->variables.n; k++)
		release_variable(formulas->variables.item[k]);
	ts_map_release(&formulas->variables.by_name);
	ts_free(formulas->variables.item);
	formulas->variables = (struct ts_variables){ 0 };
}

static enum ts_status check_name(struct ts_error *error, const struct ts_word *name)
{
	bool good = name->text[0] != '\0';

	for (const char *c = name->text; *c; c++)
		good &= isalnum((unsigned char)*c) || *c == '_';
	if (good)
		return TS_OK;
	return ts_fail(error, TS_SYNTAX, &name->place,
		       "a variable's name is made of letters, digits and _, found '%s'", name->text);
}

static enum ts_status read_values(struct ts_formulas *formulas, struct ts_variable *variable,
				  struct ts_words values)
{
	const struct ts_variable_style *style = variable->style;
	struct ts_error *error = &formulas->sim->error;

	if (values.n < style->least)
		return ts_fail(error, TS_SYNTAX, &variable->where,
			       values.n ? "a variable of style %s needs more words: %s"
					: "a variable of style %s needs a value: %s",
			       style->name, style->values);
	if (style->most && values.n > style->most)
		return ts_fail(error, TS_SYNTAX, &values.word[style->most].place,
			       style->most == 1 ? "a variable of style %s takes one word; put quotes around "
						  "a value with blanks"
						: "a variable of style %s takes %zu words",
			       style->name, style->most);
	if (ts_words_copy(&variable->arena, values, &variable->values) != TS_OK)
		return ts_nomem(error);
	return style->define ? style->define(formulas, variable) : TS_OK;
}

static enum ts_status check_existing(struct ts_formulas *formulas, const struct ts_word *name,
				     const struct ts_variable *old, const struct ts_variable_style *style)
{
	struct ts_error *error = &formulas->sim->error;

	if (old->style != style)
		return ts_fail(error, TS_STATE, &name->place,
			       "variable '%s' exists with style %s (%s:%d); 'variable %s delete' first, or "
			       "declare it here with style index",
			       name->text, old->style->name, old->where.file, old->where.line, name->text);
	if (old->busy)
		return ts_fail(error, TS_STATE, &name->place,
			       "variable '%s' cannot change while it is evaluated", name->text);
	return TS_OK;
}

enum ts_status ts_variable_define(struct ts_formulas *formulas, const struct ts_word *name,
				  const struct ts_variable_style *style, struct ts_words values)
{
	struct ts_variables *all = &formulas->variables;
	struct ts_error *error = &formulas->sim->error;
	struct ts_variable *old = ts_variable_find(formulas, name->text), *made;
	enum ts_status status;

	TS_TRY(check_name(error, name));
	if (old && style->keeps)
		return TS_OK;
	if (old)
		TS_TRY(check_existing(formulas, name, old, style));
	if (TS_GROW(all->item, all->capacity, all->n + 1) != TS_OK)
		return ts_nomem(error);
	made = ts_alloc(1, sizeof *made);
	if (!made)
		return ts_nomem(error);
	made->style = style;
	made->where = name->place;
	made->name = ts_arena_strdup(&made->arena, name->text);
	status = made->name ? read_values(formulas, made, values) : ts_nomem(error);
	if (status == TS_OK && ts_map_set(&all->by_name, made->name, made) != TS_OK)
		status = ts_nomem(error);
	if (status != TS_OK) {
		release_variable(made);
		return status;
	}
	made->used = old && old->used;
	made->place = all->n;
	all->item[all->n++] = made;
	if (old)
		ts_variable_delete(formulas, old);
	return TS_OK;
}

static enum ts_status begin_evaluation(struct ts_formulas *formulas, struct ts_variable *variable,
				       const struct ts_place *where)
{
	if (variable->busy)
		return ts_fail(&formulas->sim->error, TS_STATE, where,
			       "the formula of variable '%s' uses itself", variable->name);
	variable->busy = true;
	formulas->reads_all |= variable->style->reads_all;
	return TS_OK;
}

/* Appends to the message of a formula that failed where its variable was used, unless that is the place of
 * the error. */
static enum ts_status end_evaluation(struct ts_formulas *formulas, struct ts_variable *variable,
				     enum ts_status status, const struct ts_place *where)
{
	struct ts_error *error = &formulas->sim->error;
	size_t n = strlen(error->message);

	variable->busy = false;
	if (status == TS_OK || status == TS_NOMEM || !where || !where->line ||
	    strstr(error->message, " (variable ") ||
	    (error->place.line == where->line && ts_streq(error->place.file, where->file)))
		return status;
	snprintf(error->message + n, sizeof error->message - n, " (variable '%s', needed by %s:%d)",
		 variable->name, where->file, where->line);
	return status;
}

enum ts_status ts_variable_text(struct ts_formulas *formulas, struct ts_variable *variable,
				const struct ts_place *where, struct ts_str *out)
{
	struct ts_error *error = &formulas->sim->error;

	if (!variable->style->text)
		return ts_fail(error, TS_STATE, where,
			       "variable '%s' (style %s) has a value for each particle and cannot be put "
			       "into a line",
			       variable->name, variable->style->name);
	if (variable->open && (variable->style->number || formulas->doubts_words) &&
	    ts_unknown_read(formulas, variable->name)) {
		ts_unknown_add(formulas->sim, out, "%g", NAN);
		return TS_OK;
	}
	TS_TRY(begin_evaluation(formulas, variable, where));
	TS_TRY(end_evaluation(formulas, variable, variable->style->text(formulas, variable, where, out),
			      where));
	return out->failed ? ts_nomem(error) : TS_OK;
}

static enum ts_status parse_text_as_number(struct ts_formulas *formulas, struct ts_variable *variable,
					   const struct ts_place *where, double *out)
{
	struct ts_str text = { 0 };
	enum ts_status status = ts_variable_text(formulas, variable, where, &text);

	if (status == TS_OK && ts_unknown_read_text(formulas, ts_str_text(&text)))
		*out = NAN;
	else if (status == TS_OK && !ts_parse_real(ts_str_text(&text), out))
		status = ts_fail(&formulas->sim->error, TS_SYNTAX, where,
				 "variable '%s' is '%s', which is no number", variable->name,
				 ts_str_text(&text));
	ts_str_release(&text);
	return status;
}

enum ts_status ts_variable_number(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, double *out)
{
	const struct ts_variable_style *style = variable->style;

	if (variable->open && ts_unknown_read(formulas, variable->name)) {
		*out = NAN;
		return TS_OK;
	}
	formulas->misfit |= (style->peratom || style->vector) && !style->number;
	if (style->peratom && !style->number)
		return ts_fail(&formulas->sim->error, TS_STATE, where,
			       "variable '%s' has a value for each particle; one number is needed here",
			       variable->name);
	if (style->vector && !style->number)
		return ts_fail(&formulas->sim->error, TS_STATE, where,
			       "variable '%s' is a list of numbers; choose one with v_%s[k]", variable->name,
			       variable->name);
	if (!style->number)
		return parse_text_as_number(formulas, variable, where, out);
	TS_TRY(begin_evaluation(formulas, variable, where));
	return end_evaluation(formulas, variable, style->number(formulas, variable, where, out), where);
}

enum ts_status ts_variable_peratom(struct ts_formulas *formulas, struct ts_variable *variable,
				   const struct ts_place *where, struct ts_table *out)
{
	if (!variable->style->peratom)
		return ts_fail(&formulas->sim->error, TS_STATE, where,
			       "variable '%s' is of style %s; values for each particle need style atom or "
			       "atomfile",
			       variable->name, variable->style->name);
	TS_TRY(begin_evaluation(formulas, variable, where));
	return end_evaluation(formulas, variable, variable->style->peratom(formulas, variable, where, out),
			      where);
}

enum ts_status ts_variable_vector(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, struct ts_table *out)
{
	if (!variable->style->vector)
		return ts_fail(&formulas->sim->error, TS_STATE, where,
			       "variable '%s' is of style %s; a list of numbers needs style vector",
			       variable->name, variable->style->name);
	TS_TRY(begin_evaluation(formulas, variable, where));
	return end_evaluation(formulas, variable, variable->style->vector(formulas, variable, where, out),
			      where);
}

enum ts_status ts_variable_column(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, struct ts_table *out)
{
	TS_TRY(begin_evaluation(formulas, variable, where));
	return end_evaluation(formulas, variable, variable->style->columns(formulas, variable, where, out),
			      where);
}

enum ts_status ts_variable_next(struct ts_formulas *formulas, struct ts_variable *variable,
				const struct ts_place *where, bool *exhausted)
{
	if (!variable->style->next)
		return ts_fail(&formulas->sim->error, TS_STATE, where,
			       "'next' needs an index, loop or file variable; '%s' is of style %s",
			       variable->name, variable->style->name);
	return variable->style->next(formulas, variable, exhausted);
}
