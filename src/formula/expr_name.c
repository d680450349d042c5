/* Values of names in formulas. */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "core/ranks.h"
#include "core/ranks_pause.h"
#include "math/constants.h"
#include "formula/expr.h"

#include "base/banned.h"

const struct ts_constant ts_constants[] = {
	{ "PI", TS_PI, "ratio of a circle's circumference to its diameter" },
	{ "yes", 1, "1" },
	{ "no", 0, "0" },
	{ "true", 1, "1" },
	{ "false", 0, "0" },
	{ "on", 1, "1" },
	{ "off", 0, "0" },
	{ .name = NULL },
};

static const struct ts_constant *constant_find(const char *name)
{
	for (const struct ts_constant *c = ts_constants; c->name; c++)
		if (ts_streq(c->name, name))
			return c;
	return NULL;
}

/* An index whose value is unknown. */
static const int64_t OPEN_INDEX = INT64_MIN;

/* The number between [ and ], at least `least`, or OPEN_INDEX. */
static enum ts_status read_index(struct ts_expr *e, double least, int64_t *out)
{
	size_t at = e->at++;
	double k = 0;

	TS_TRY(ts_expr_read_number(e, &k));
	if (ts_expr_peek(e) != ']')
		return ts_expr_fail(e, TS_SYNTAX, at, at + 1, "'[' is never closed");
	e->at++;
	*out = OPEN_INDEX;
	if (ts_unknown(e->sim, k))
		return TS_OK;
	if (!(k >= least && k < 9e15) || floor(k) < k)
		return ts_expr_fail(e, TS_RANGE, at, e->at,
				    "expected a whole number from %.0f on between [ and ], found %.15g",
				    least, k);
	*out = (int64_t)k;
	return TS_OK;
}

/* The index in storage of the particle with that identity. */
static enum ts_status find_particle(struct ts_expr *e, int64_t identity, size_t at, size_t *row)
{
	struct ts_table id = { 0 };
	enum ts_status status;

	TS_TRY(ts_expr_locate_error(e, ts_ranks_look(e->sim), at, e->at));
	status = ts_quantity_eval(e->sim, "id", &id);
	*row = 0;
	while (status == TS_OK && *row < id.rows && (int64_t)id.data[*row] != identity)
		++*row;
	if (status == TS_OK && *row == id.rows)
		status = ts_expr_fail(e, TS_RANGE, at, e->at, "there is no particle with id %" PRId64,
				      identity);
	ts_table_release(&id);
	return ts_expr_locate_error(e, status, at, e->at);
}

/* v_NAME[k] of a variable of style atom: the value of the particle with identity k. */
static enum ts_status variable_of_particle(struct ts_expr *e, struct ts_variable *variable,
					   const struct ts_place *place, int64_t k, size_t at,
					   struct ts_operand *out)
{
	struct ts_table table = { 0 };
	enum ts_status status;
	size_t row = 0;

	e->formulas->reads_all = true;
	status = find_particle(e, k, at, &row);
	if (status == TS_OK)
		status = ts_variable_peratom(e->formulas, variable, place, &table);
	if (status == TS_OK)
		out->scalar = table.data[row];
	ts_table_release(&table);
	return ts_expr_or_unknown(e, variable->name, status, out);
}

/* v_NAME[k] of a variable of style vector: element k. */
static enum ts_status element_of_vector(struct ts_expr *e, struct ts_variable *variable,
					const struct ts_place *place, int64_t k, size_t at,
					struct ts_operand *out)
{
	struct ts_table table = { 0 };
	enum ts_status status = ts_variable_vector(e->formulas, variable, place, &table);
	/* with -check a list that a run would fill is empty, or has unknown numbers */
	bool open = k == OPEN_INDEX || (status == TS_OK && !table.rows && ts_unknown(e->sim, NAN));

	/* rows of chunks, say, are counted in a run */
	open |= status == TS_OK && !table.rows && ts_unknown_read(e->formulas, variable->name);
	for (size_t i = 0; i < table.rows; i++)
		open |= ts_unknown(e->sim, table.data[i]) && (size_t)k > table.rows;
	if (status == TS_OK && open)
		out->scalar = NAN;
	else if (status == TS_OK && (size_t)k > table.rows)
		status = ts_expr_fail(e, TS_RANGE, at, e->at,
				      "element [%" PRId64 "] asked for, variable '%s' has %zu", k,
				      variable->name, table.rows);
	else if (status == TS_OK)
		out->scalar = table.data[k - 1];
	ts_table_release(&table);
	return status;
}

static enum ts_status element_of_variable(struct ts_expr *e, struct ts_variable *variable,
					  const struct ts_place *place, size_t at, struct ts_operand *out)
{
	int64_t k = 0;

	TS_TRY(read_index(e, 1, &k));
	if (variable->style->vector)
		return element_of_vector(e, variable, place, k, at, out);
	if (variable->style->peratom && !variable->style->number)
		return variable_of_particle(e, variable, place, k, at, out);
	return ts_expr_fail(e, TS_SYNTAX, at, e->at,
			    "variable '%s' (style %s) has one value; '[' is allowed only behind a variable "
			    "of style vector or atom",
			    variable->name, variable->style->name);
}

static enum ts_status read_variable(struct ts_expr *e, const char *name, size_t at, struct ts_operand *out)
{
	struct ts_place place = ts_place_inside(e->place, e->length, at, e->at - at);
	struct ts_table table = { 0 };
	struct ts_variable *found;

	TS_TRY(ts_variable_require(e->formulas, name + 2, &place, &found));
	if (e->text[e->at] == '[')
		return element_of_variable(e, found, &place, at, out);
	if (e->kind == TS_FORMULA_PERATOM && found->style->peratom && !found->style->number)
		return ts_expr_take_table(e, ts_variable_peratom(e->formulas, found, &place, &table), &table,
					  out);
	if (e->kind == TS_FORMULA_VECTOR && found->style->vector)
		return ts_expr_take_table(e, ts_variable_vector(e->formulas, found, &place, &table), &table,
					  out);
	if (e->kind == TS_FORMULA_COLUMNS && found->style->columns)
		return ts_expr_take_table(e, ts_variable_column(e->formulas, found, &place, &table), &table,
					  out);
	return ts_variable_number(e->formulas, found, &place, &out->scalar);
}

/* c_ID[k] of a style without a vector but with per-particle values: the value of the particle with
 * identity k. */
static enum ts_status output_of_particle(struct ts_expr *e, const char *name, int64_t identity,
					 int64_t column, size_t at, struct ts_operand *out)
{
	struct ts_place place = ts_place_inside(e->place, e->length, at, e->at - at);
	struct ts_table table = { 0 };
	struct ts_str whole = { 0 };
	enum ts_status status;
	struct ts_ref ref;
	size_t row = 0;

	ts_str_add(&whole, name);
	if (column)
		ts_str_addf(&whole, "[%" PRId64 "]", column);
	status = whole.failed ? ts_nomem(&e->sim->error) : ts_ref_resolve(e->sim, whole.text, &place, &ref);
	if (status == TS_OK)
		status = find_particle(e, identity, at, &row);
	if (status == TS_OK)
		status = ts_ref_peratom(e->sim, &ref, &place, &table);
	if (status == TS_OK)
		out->scalar = table.data[row * table.columns];
	ts_table_release(&table);
	ts_str_release(&whole);
	return status;
}

/* The values of a reference in this kind of formula. */
static enum ts_status value_of_reference(struct ts_expr *e, const struct ts_ref *ref,
					 const struct ts_place *place, struct ts_operand *out)
{
	unsigned shapes = ts_ref_shapes(e->sim, ref);
	struct ts_table table = { 0 };

	if (e->kind == TS_FORMULA_PERATOM && shapes & (1u << TS_PERATOM) && !(shapes & (1u << TS_SCALAR)))
		return ts_expr_take_table(e, ts_ref_peratom(e->sim, ref, place, &table), &table, out);
	if (e->kind == TS_FORMULA_VECTOR && shapes & (1u << TS_VECTOR)) {
		enum ts_status status = ts_ref_vector(e->sim, ref, place, &table);

		table.rows *= table.columns;
		table.columns = 1;
		return ts_expr_take_table(e, status, &table, out);
	}
	if (e->kind == TS_FORMULA_VECTOR && shapes & (1u << TS_LOCAL))
		return ts_expr_take_table(e, ts_ref_local(e->sim, ref, place, &table), &table, out);
	if (e->kind == TS_FORMULA_VECTOR && shapes & (1u << TS_PERATOM))
		return ts_expr_take_table(e, ts_ref_peratom(e->sim, ref, place, &table), &table, out);
	return ts_ref_scalar(e->sim, ref, place, &out->scalar);
}

/* Whether the style has an output of a shape that the formula needs, as far as that is known without a
 * run. */
static bool has_shape(const struct ts_expr *e, const struct ts_ref *ref, unsigned shapes, bool of_identity)
{
	const struct ts_value *list = ref->inst ? ts_value_find(ref->inst, TS_VECTOR) : NULL;
	unsigned wanted = 1u << TS_SCALAR;

	if (e->kind == TS_FORMULA_PERATOM || of_identity)
		wanted |= 1u << TS_PERATOM;
	if (e->kind == TS_FORMULA_VECTOR)
		wanted |= 1u << TS_VECTOR | 1u << TS_LOCAL | 1u << TS_PERATOM;
	if (list && list->columns && !ref->column && ref->index > (long)list->columns)
		wanted &= ~(1u << TS_SCALAR);
	return shapes & wanted;
}

static enum ts_status require_all_particles(struct ts_expr *e, const char *name, size_t at)
{
	return ts_expr_locate_error(e, ts_ranks_require_all(e->sim, name, NULL), at, e->at);
}

/* After a run ranks have lists of their own particles only. */
static enum ts_status require_lists(struct ts_expr *e, bool reads_lists, size_t at)
{
	return reads_lists ? ts_expr_locate_error(e, ts_ranks_unite(e->sim), at, e->at) : TS_OK;
}

/* The result of a dry run. */
static enum ts_status set_unknown(struct ts_operand *out)
{
	out->scalar = NAN;
	return TS_OK;
}

/* Whether [k] is the particle of identity k, as in LAMMPS and LIGGGHTS: of one number for each particle, also in a formula for
 * each particle, where [k] of several numbers is the k-th. */
static bool is_of_identity(const struct ts_expr *e, const struct ts_ref *ref, unsigned shapes)
{
	const struct ts_value *value = ref->inst ? ts_value_find(ref->inst, TS_PERATOM) : NULL;

	if (!(shapes & (1u << TS_PERATOM)))
		return false;
	return e->kind == TS_FORMULA_SCALAR ||
	       (e->kind == TS_FORMULA_PERATOM && value && ts_value_width(ref->inst, value) == 1);
}

static enum ts_status read_output(struct ts_expr *e, const char *name, const char *whole, const int64_t k[2],
				  size_t at, struct ts_operand *out)
{
	struct ts_place place = ts_place_inside(e->place, e->length, at, e->at - at);
	enum ts_status status;
	bool identity, given;
	struct ts_ref ref;
	unsigned shapes;

	e->formulas->reads_all = true;
	TS_TRY(ts_ref_resolve(e->sim, whole, &place, &ref));
	shapes = ts_ref_shapes(e->sim, &ref);
	identity = k[0] > 0 && !(shapes & (1u << TS_SCALAR)) && (k[1] > 0 || is_of_identity(e, &ref, shapes));
	given = has_shape(e, &ref, shapes, identity);
	e->formulas->misfit |= !given;
	if (e->sim->reading.dry && given)
		return set_unknown(out);
	TS_TRY(require_all_particles(e, name, at));
	TS_TRY(require_lists(e, !(ref.inst && ref.inst->style->ranks & TS_RANKS_PARTICLES), at));
	status = identity ? output_of_particle(e, name, k[0], k[1], at, out)
			  : value_of_reference(e, &ref, &place, out);
	return given ? ts_expr_or_unknown(e, name, status, out) : status;
}

/* c_ID, c_ID[k], c_ID[k][j], and the same of fixes */
static enum ts_status read_output_name(struct ts_expr *e, const char *name, size_t at, struct ts_operand *out)
{
	enum ts_status status = TS_OK;
	struct ts_str whole = { 0 };
	int64_t k[2] = { -1, 0 };
	bool open = false;

	ts_str_add(&whole, name);
	for (int n = 0; n < 2 && status == TS_OK && e->text[e->at] == '['; n++) {
		status = read_index(e, n, &k[n]);
		open |= k[n] == OPEN_INDEX;
		k[n] = k[n] == OPEN_INDEX ? 1 : k[n];
		ts_str_addf(&whole, "[%" PRId64 "]", k[n]);
	}
	if (status == TS_OK)
		status = whole.failed ? ts_nomem(&e->sim->error)
				      : read_output(e, name, whole.text, k, at, out);
	ts_str_release(&whole);
	if (status == TS_OK && open)
		*out = (struct ts_operand){ .scalar = NAN, .at = at };
	return ts_expr_locate_error(e, status, at, e->at);
}

/* Keywords that do not depend on the particles of other ranks; all ranks have the whole fluid where formulas read it. */
enum { ALONE = TS_KEYWORD_CONSTANT | TS_KEYWORD_CLOCK | TS_KEYWORD_BOX | TS_KEYWORD_FLUID };

/* Whether keywords are judged before they are evaluated, which tells by itself whether they have a value. */
static bool is_judged(const struct tsim *sim)
{
	return (sim->reading.dry || sim->reading.explain) && !sim->reading.unreached;
}

/* A thermo keyword. The values of some are known behind a run that is left out. */
static enum ts_status value_of_keyword(struct ts_expr *e, const struct ts_keyword *keyword, size_t at,
				       struct ts_operand *out)
{
	bool known = keyword->flags & TS_KEYWORD_CONSTANT ||
		     (keyword->flags & TS_KEYWORD_CLOCK && !e->sim->reading.open_clock) ||
		     (keyword->flags & TS_KEYWORD_BOX && !e->sim->run.box_moves);
	enum ts_status status;

	e->formulas->reads_all |= !(keyword->flags & ALONE);
	e->formulas->reads_fluid |= keyword->flags & TS_KEYWORD_FIELDS;
	status = is_judged(e->sim) ? ts_keyword_check(e->sim, keyword, NULL) : TS_OK;
	if (status != TS_OK) /* in a dry run like an output that does not exist yet */
		return ts_expr_locate_error(e, e->sim->reading.dry ? TS_UNKNOWN : status, at, e->at);
	if (e->sim->reading.dry)
		return set_unknown(out);
	if (!(keyword->flags & (ALONE | TS_KEYWORD_SUM)) ||
	    (keyword->flags & TS_KEYWORD_SUM && e->sim->run.apart))
		TS_TRY(require_all_particles(e, keyword->name, at));
	TS_TRY(require_lists(e, keyword->flags & (TS_KEYWORD_CONTACTS | TS_KEYWORD_LISTS), at));
	status = keyword->eval(e->sim, &out->scalar);
	return ts_expr_locate_error(e, known ? status : ts_expr_or_unknown(e, keyword->name, status, out), at,
				    e->at);
}

/* A quantity of all particles, e.g. `vx` in a formula of style atom. */
static enum ts_status quantity_of_particles(struct ts_expr *e, const char *name, size_t at,
					    struct ts_operand *out)
{
	struct ts_table table = { 0 };
	enum ts_status status;

	if (e->sim->reading.dry)
		return set_unknown(out);
	if (!e->sim->run.rowwise) {
		TS_TRY(require_all_particles(e, name, at));
		TS_TRY(require_lists(e, true, at));
	}
	status = ts_quantity_eval(e->sim, name, &table);
	status = ts_expr_take_table(e, status, &table, out);
	return ts_expr_locate_error(e, ts_expr_or_unknown(e, name, status, out), at, e->at);
}

/* A quantity of the particle with a given identity: vx[17]. */
static enum ts_status quantity_of_particle(struct ts_expr *e, const char *name, size_t at,
					   struct ts_operand *out)
{
	struct ts_table table = { 0 };
	enum ts_status status;
	int64_t identity = 0;
	size_t row = 0;

	e->formulas->reads_all = true;
	TS_TRY(read_index(e, 1, &identity));
	TS_TRY(require_all_particles(e, name, at));
	TS_TRY(require_lists(e, true, at));
	status = find_particle(e, identity, at, &row);
	if (status == TS_OK)
		status = ts_quantity_eval(e->sim, name, &table);
	if (status == TS_OK)
		out->scalar = table.data[row];
	ts_table_release(&table);
	return ts_expr_locate_error(e, ts_expr_or_unknown(e, name, status, out), at, e->at);
}

static enum ts_status fail_unknown_name(struct ts_expr *e, const char *name, size_t at, bool call)
{
	struct ts_suggest suggest = ts_suggest_start(name);
	struct ts_str with_prefix = { 0 };
	enum ts_status status;

	ts_str_addf(&with_prefix, "v_%s", name);
	for (const struct ts_system_style *const *s = e->sim->tables->systems; *s; s++) {
		for (const struct ts_keyword *k = (*s)->keywords; !call && k && k->name; k++)
			ts_suggest_try(&suggest, k->name);
		for (const struct ts_function *f = (*s)->functions; call && f && f->name; f++)
			ts_suggest_try(&suggest, f->name);
	}
	if (call) {
		for (const struct ts_expr_function *const *t = ts_expr_functions; *t; t++)
			for (const struct ts_expr_function *f = *t; f->name; f++)
				ts_suggest_try(&suggest, f->name);
	} else {
		for (const struct ts_constant *c = ts_constants; c->name; c++)
			ts_suggest_try(&suggest, c->name);
		if (e->kind == TS_FORMULA_PERATOM)
			ts_quantity_suggest(e->sim, &suggest);
		if (ts_variable_find(e->formulas, name)) /* most likely v_ is missing */
			suggest.distance = 0, suggest.best = ts_str_text(&with_prefix);
	}
	status = ts_expr_fail(e, TS_UNKNOWN, at, at + strlen(name), "unknown %s '%s'%s",
			      call ? "function" : "name", name, ts_suggest_text(&suggest));
	ts_str_release(&with_prefix);
	return status;
}

static enum ts_status call_function(struct ts_expr *e, const char *name, size_t at, struct ts_operand *out)
{
	const struct ts_expr_function *function = ts_expr_function_find(name);
	const struct ts_function *of_group = ts_function_find(e->sim->tables, name);

	if (function)
		return ts_expr_call(e, function, at, out);
	if (of_group)
		return ts_expr_call_group(e, of_group, at, out);
	return fail_unknown_name(e, name, at, true);
}

/* A bare word of a condition. Constants also have a number; property_NAME is 1 if there is a material
 * property NAME. */
static enum ts_status value_of_bare_word(struct ts_expr *e, const char *name, struct ts_operand *out)
{
	static const char property[] = "property_";
	const struct ts_constant *constant = constant_find(name);

	if (strncmp(name, property, sizeof property - 1) == 0) {
		out->scalar = ts_sim_has_property(e->sim, name + sizeof property - 1);
		return TS_OK;
	}
	out->word = name;
	out->is_word = !constant;
	out->scalar = constant ? constant->value : ts_unknown_read_text(e->formulas, name) ? NAN : 0;
	return TS_OK;
}

enum ts_status ts_expr_name(struct ts_expr *e, const char *name, size_t at, struct ts_operand *out)
{
	const struct ts_constant *constant = constant_find(name);
	const struct ts_keyword *keyword;
	char next = e->text[e->at];

	if (strncmp(name, "v_", 2) == 0)
		return read_variable(e, name, at, out);
	if (next == '[' && strncmp(name, "f_", 2) == 0 && e->kind != TS_FORMULA_PERATOM &&
	    !ts_sim_find(e->sim, TS_KIND_FIX, name + 2) && ts_quantity_kept(e->sim, name + 2) &&
	    ts_quantity_has(e->sim, name + 2))
		return quantity_of_particle(e, name + 2, at, out);
	if (strncmp(name, "c_", 2) == 0 || strncmp(name, "f_", 2) == 0)
		return read_output_name(e, name, at, out);
	if (next == '(')
		return call_function(e, name, at, out);
	if (next == '[' && ts_quantity_has(e->sim, name))
		return quantity_of_particle(e, name, at, out);
	if (e->kind == TS_FORMULA_PERATOM && ts_quantity_has(e->sim, name))
		return quantity_of_particles(e, name, at, out);
	if (e->condition)
		return value_of_bare_word(e, name, out);
	if (constant) {
		out->scalar = constant->value;
		return TS_OK;
	}
	keyword = ts_keyword_find(e->sim->tables, name);
	if (keyword)
		return value_of_keyword(e, keyword, at, out);
	return fail_unknown_name(e, name, at, false);
}
