#include "script/script.h"

#include "core/life.h"
#include "formula/expr.h"
#include "script/check.h"

#include "base/banned.h"

struct ts_script *ts_script_new(struct tsim *sim)
{
	struct ts_script *script = ts_alloc(1, sizeof *script);

	if (!script)
		return NULL;
	script->sim = script->formulas.sim = sim;
	sim->script_api = &ts_script_api_table;
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
	*out = sim->script_api == &ts_script_api_table ? sim->script_api_data : NULL;
	if (*out)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, where, "this command works only in a script");
}

enum ts_status ts_script_check(struct ts_script *script)
{
	script->sim->reading.explain = script->sim->reading.check = true;
	return script->check ? TS_OK : ts_check_new(script);
}

enum ts_status ts_script_set_variable(struct ts_script *script, const char *name, const char *const *values,
				      size_t n, const char *origin)
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

enum ts_status ts_script_define_variable(struct ts_script *script, const char *name, const char *style,
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
	if (old) /* hidden, not deleted, until the new one has been defined */
		ts_map_remove(&script->formulas.variables.by_name, old->name);
	status = ts_sim_command(script->sim, (struct ts_words){ word, value ? 4 : 3 });
	if (old && status == TS_OK)
		ts_variable_delete(&script->formulas, old);
	else if (old && ts_map_set(&script->formulas.variables.by_name, old->name, old) != TS_OK)
		return ts_nomem(&script->sim->error);
	return status;
}

const char *ts_script_variable_name(struct ts_script *script, size_t k)
{
	ts_variables_compact(&script->formulas);
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
