#include <string.h>

#include "script/expr.h"

#include "base/banned.h"

static const double pi = 3.14159265358979323846;

static enum ts_status variable(struct ts_expr *e, const char *name, size_t at,
			       struct ts_operand *out)
{
	struct ts_place place = ts_place_inside(e->place, e->length, at, e->at - at);
	struct ts_variable *found;
	struct ts_table table = { 0 };
	enum ts_status status;

	TS_TRY(ts_variable_require(e->script, name + 2, &place, &found));
	if (!e->peratom || found->style != TS_VAR_ATOM)
		return ts_variable_number(e->script, found, &place, &out->scalar);
	status = ts_variable_peratom(e->script, found, &place, &table);
	if (status == TS_OK) {
		out->data = ts_expr_array(e);
		status = out->data ? TS_OK : TS_NOMEM;
	}
	if (status == TS_OK && e->rows)
		memcpy(out->data, table.data, e->rows * sizeof *out->data);
	ts_table_release(&table);
	return status;
}

/* Takes the [..] or [..][..] behind the name into account. */
static enum ts_status read_index(struct ts_expr *e)
{
	const char *close;

	while (e->text[e->at] == '[') {
		close = strchr(e->text + e->at, ']');
		if (!close)
			return ts_expr_fail(e, TS_SYNTAX, e->at, e->at + 1,
					    "'[' is never closed");
		e->at = (size_t)(close - e->text) + 1;
	}
	return TS_OK;
}

/* c_ID, c_ID[k], f_ID, f_ID[k] */
static enum ts_status output(struct ts_expr *e, size_t at, struct ts_operand *out)
{
	struct ts_table table = { 0 };
	struct ts_place place;
	struct ts_ref ref;
	enum ts_status status;
	const char *name;
	unsigned shapes;

	TS_TRY(read_index(e));
	place = ts_place_inside(e->place, e->length, at, e->at - at);
	name = ts_expr_copy(e, at, e->at);
	if (!name)
		return TS_NOMEM;
	TS_TRY(ts_expr_blame(e, ts_ref_resolve(e->sim, name, &place, &ref), at, e->at));
	shapes = ts_ref_shapes(e->sim, &ref);
	if (!e->peratom || shapes & (1u << TS_SCALAR) || !(shapes & (1u << TS_PERATOM)))
		return ts_expr_blame(e, ts_ref_scalar(e->sim, &ref, &place, &out->scalar), at,
				     e->at);
	status = ts_ref_peratom(e->sim, &ref, &place, &table);
	if (status == TS_OK) {
		out->data = ts_expr_array(e);
		status = out->data ? TS_OK : TS_NOMEM;
	}
	for (size_t i = 0; status == TS_OK && i < e->rows; i++)
		out->data[i] = table.data[i * table.columns];
	ts_table_release(&table);
	return ts_expr_blame(e, status, at, e->at);
}

/* A quantity of all particles, e.g. `vx` in an atom-style formula. */
static enum ts_status column(struct ts_expr *e, const char *name, size_t at, struct ts_operand *out)
{
	struct ts_table table = { 0 };
	enum ts_status status = ts_quantity_eval(e->sim, name, &table);

	if (status == TS_OK) {
		out->data = ts_expr_array(e);
		status = out->data ? TS_OK : TS_NOMEM;
	}
	if (status == TS_OK && e->rows)
		memcpy(out->data, table.data, e->rows * sizeof *out->data);
	ts_table_release(&table);
	return ts_expr_blame(e, status, at, e->at);
}

/* A quantity of the particle with a given identity: vx[17]. */
static enum ts_status of_particle(struct ts_expr *e, const char *name, size_t at,
				  struct ts_operand *out)
{
	struct ts_table id = { 0 }, table = { 0 };
	struct ts_operand index;
	enum ts_status status;
	size_t i = 0;

	e->at++;
	TS_TRY(ts_expr_read(e, 1, &index));
	TS_TRY(ts_expr_expect(e, ']'));
	TS_TRY(ts_op_need_number(e, &index));
	if (index.data)
		return ts_expr_fail(e, TS_SYNTAX, at, e->at,
				    "expected one identity between [ and ], found one for each "
				    "particle");
	status = ts_quantity_eval(e->sim, "id", &id);
	if (status == TS_OK)
		status = ts_quantity_eval(e->sim, name, &table);
	while (status == TS_OK && i < id.rows &&
	       (id.data[i] < index.scalar || id.data[i] > index.scalar))
		i++;
	if (status == TS_OK && i == id.rows)
		status = ts_expr_fail(e, TS_RANGE, at, e->at, "there is no particle with id %.15g",
				      index.scalar);
	if (status == TS_OK)
		out->scalar = table.data[i];
	ts_table_release(&id);
	ts_table_release(&table);
	return ts_expr_blame(e, status, at, e->at);
}

static enum ts_status unknown(struct ts_expr *e, const char *name, size_t at, bool call)
{
	struct ts_suggest suggest = ts_suggest_start(name);
	struct ts_str with_prefix = { 0 };
	enum ts_status status;

	ts_str_addf(&with_prefix, "v_%s", name);
	for (const struct ts_system_style *const *s = ts_system_table; *s; s++) {
		for (const struct ts_keyword *k = (*s)->keywords; !call && k && k->name; k++)
			ts_suggest_try(&suggest, k->name);
		for (const struct ts_function *f = (*s)->functions; call && f && f->name; f++)
			ts_suggest_try(&suggest, f->name);
	}
	if (call) {
		ts_math_function_suggest(&suggest);
		ts_series_function_suggest(&suggest);
	} else {
		ts_suggest_try(&suggest, "PI");
		if (e->peratom)
			ts_quantity_suggest(&suggest);
		if (ts_variable_find(e->script, name)) /* a forgotten v_ explains best */
			suggest.distance = 0, suggest.best = ts_str_text(&with_prefix);
	}
	status = ts_expr_fail(e, TS_UNKNOWN, at, at + strlen(name), "unknown %s '%s'%s",
			      call ? "function" : "name", name, ts_suggest_text(&suggest));
	ts_str_release(&with_prefix);
	return status;
}

static enum ts_status call(struct ts_expr *e, const char *name, size_t at, struct ts_operand *out)
{
	const struct ts_math_function *math = ts_math_function_find(name);
	const struct ts_series_function *series = ts_series_function_find(name);
	const struct ts_function *function = ts_function_find(e->sim, name);

	if (math)
		return ts_math_function_call(e, math, at, out);
	if (series)
		return ts_series_function_call(e, series, at, out);
	if (function)
		return ts_group_function_call(e, function, at, out);
	return unknown(e, name, at, true);
}

enum ts_status ts_expr_name(struct ts_expr *e, const char *name, size_t at, struct ts_operand *out)
{
	const struct ts_keyword *keyword;
	char next = e->text[e->at];

	if (strncmp(name, "v_", 2) == 0)
		return variable(e, name, at, out);
	if (strncmp(name, "c_", 2) == 0 || strncmp(name, "f_", 2) == 0)
		return output(e, at, out);
	if (next == '(')
		return call(e, name, at, out);
	if (next == '[' && ts_quantity_has(e->sim, name))
		return of_particle(e, name, at, out);
	if (e->peratom && ts_quantity_has(e->sim, name))
		return column(e, name, at, out);
	if (ts_streq(name, "PI")) {
		out->scalar = pi;
		out->word = name;
		return TS_OK;
	}
	if (e->condition) {
		out->word = name;
		out->is_word = true;
		return TS_OK;
	}
	keyword = ts_keyword_find(e->sim, name);
	if (keyword)
		return ts_expr_blame(e, keyword->eval(e->sim, &out->scalar), at, e->at);
	return unknown(e, name, at, false);
}
