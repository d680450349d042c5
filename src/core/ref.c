#include "core/ref.h"

#include <stdio.h>
#include <string.h>

#include "core/ranks.h"
#include "core/sim.h"

#include "base/banned.h"

enum { MOST_ID = 128 };

/* Parses "[12]" and moves *text behind it. */
static bool parse_bracket(const char **text, long *index)
{
	const char *close = strchr(*text, ']');
	size_t n = close ? (size_t)(close - *text) : 0;
	char digits[16];
	int64_t k;

	if (**text != '[' || n < 2 || n > sizeof digits)
		return false;
	memcpy(digits, *text + 1, n - 1);
	digits[n - 1] = '\0';
	if (!ts_parse_int(digits, &k) || k < 0 || k > 1000000000)
		return false;
	*index = (long)k;
	*text = close + 1;
	return true;
}

/* "name[12][3]" -> name, 12 and 3; a missing index is 0. */
static bool parse_indices(const char *text, char *name, size_t size, long *index, long *column)
{
	size_t n = strcspn(text, "[");

	*index = *column = 0;
	if (n >= size)
		return false;
	memcpy(name, text, n);
	name[n] = '\0';
	text += n;
	if (*text && !parse_bracket(&text, index))
		return false;
	if (*text && (*index == 0 || !parse_bracket(&text, column) || *column == 0))
		return false;
	return *text == '\0';
}

/* v_name, or v_name[k] of a variable of style vector */
static enum ts_status resolve_variable(struct tsim *sim, const char *name, const struct ts_place *where,
				       struct ts_ref *ref)
{
	struct ts_suggest suggest;
	char plain[128];

	ref->kind = TS_REF_VARIABLE;
	if (!parse_indices(name, plain, sizeof plain, &ref->index, &ref->column) || ref->column)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "'v_%s' is malformed, expected v_NAME or v_NAME[k]", name);
	ref->variable = ts_pool_get(sim->pool, plain);
	if (!ref->variable)
		return ts_nomem(&sim->error);
	if (!sim->script_api || !sim->script_api->has_variable(sim->script_api_data, plain)) {
		suggest = ts_suggest_start(plain);
		if (sim->script_api)
			sim->script_api->suggest_variable(sim->script_api_data, &suggest);
		return ts_missing(&sim->error, "variable", plain, where, "unknown variable '%s'%s", plain,
				  ts_suggest_text(&suggest));
	}
	if (ref->index && !sim->script_api->is_vector(sim->script_api_data, plain))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "variable '%s' is not of style vector: v_%s[k] has no meaning", plain, plain);
	return TS_OK;
}

static enum ts_status resolve_keyword(struct tsim *sim, const char *name, const struct ts_place *where,
				      struct ts_ref *ref)
{
	struct ts_suggest suggest = ts_suggest_start(name);

	ref->kind = TS_REF_KEYWORD;
	ref->keyword = ts_keyword_find(sim->tables, name);
	if (ref->keyword) {
		ts_keyword_shows(sim, ref->keyword);
		return TS_OK;
	}
	for (const struct ts_system_style *const *s = sim->tables->systems; *s; s++)
		for (const struct ts_keyword *k = (*s)->keywords; k && k->name; k++)
			ts_suggest_try(&suggest, k->name);
	return ts_fail(&sim->error, TS_UNKNOWN, where,
		       "unknown quantity '%s', expected a thermo keyword, c_ID, f_ID or v_name%s", name,
		       ts_suggest_text(&suggest));
}

static enum ts_status resolve_instance(struct tsim *sim, const char *name, enum ts_kind kind,
				       const struct ts_place *where, struct ts_ref *ref)
{
	char id[MOST_ID];
	struct ts_word word = { .text = id };

	if (where)
		word.place = *where;
	ref->kind = kind == TS_KIND_COMPUTE ? TS_REF_COMPUTE : TS_REF_FIX;
	if (!parse_indices(name + 2, id, sizeof id, &ref->index, &ref->column))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "'%s' is malformed, expected %.2sID, %.2sID[k] or %.2sID[i][j]", name, name,
			       name, name);
	if (kind == TS_KIND_FIX && !ts_sim_find(sim, kind, id) && ts_quantity_kept(sim, name + 2)) {
		ref->kind = TS_REF_COLUMN;
		ref->quantity = name + 2;
		return TS_OK;
	}
	TS_TRY(ts_sim_require(sim, kind, &word, &ref->inst));
	if (kind == TS_KIND_FIX && ref->inst->style->ranks & TS_RANKS_OWN &&
	    !(ref->inst->style->ranks & TS_RANKS_OUTPUTS))
		TS_TRY(ts_ranks_refuse(sim, name, where));
	sim->run.shows_lists |= kind == TS_KIND_FIX && ref->inst->style->ranks & TS_RANKS_WHOLE &&
				!(ref->inst->style->ranks & TS_RANKS_PARTICLES);
	if (!ref->inst->style->values)
		return ts_fail(&sim->error, TS_STATE, where, "%s %s (%s) has no output to read",
			       ts_kind_name(kind), id, ref->inst->style->name);
	return TS_OK;
}

/* The thermo keyword that replaces a compute which LIGGGHTS and LAMMPS define by themselves; NULL: none. */
static const char *standard_keyword(const struct tsim *sim, const char *name)
{
	static const struct {
		const char *name, *keyword;
	} rows[] = {
		{ "c_thermo_temp", "temp" },	{ "c_thermo_pe", "pe" },
		{ "c_thermo_press", "press" },	{ "c_thermo_press[1]", "pxx" },
		{ "c_thermo_press[2]", "pyy" }, { "c_thermo_press[3]", "pzz" },
		{ "c_thermo_press[4]", "pxy" }, { "c_thermo_press[5]", "pxz" },
		{ "c_thermo_press[6]", "pyz" },
	};
	char id[16];

	for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
		if (!ts_streq(rows[k].name, name))
			continue;
		snprintf(id, sizeof id, "%.*s", (int)strcspn(name + 2, "["), name + 2);
		return ts_sim_find(sim, TS_KIND_COMPUTE, id) ? NULL : rows[k].keyword;
	}
	return NULL;
}

size_t ts_ref_standard_elements(const struct tsim *sim, const char *head)
{
	size_t n = 0;
	char name[32];

	do
		snprintf(name, sizeof name, "%s[%zu]", head, n + 1);
	while (standard_keyword(sim, name) && ++n);
	return n;
}

enum ts_status ts_ref_resolve(struct tsim *sim, const char *name, const struct ts_place *where,
			      struct ts_ref *ref)
{
	const char *keyword = standard_keyword(sim, name);

	*ref = (struct ts_ref){ .name = name, .removals = sim->removals - 1 }; /* not yet resolved */
	if (!keyword && strncmp(name, "c_", 2) == 0)
		TS_TRY(resolve_instance(sim, name, TS_KIND_COMPUTE, where, ref));
	else if (!keyword && strncmp(name, "f_", 2) == 0)
		TS_TRY(resolve_instance(sim, name, TS_KIND_FIX, where, ref));
	else if (!keyword && strncmp(name, "v_", 2) == 0)
		TS_TRY(resolve_variable(sim, name + 2, where, ref));
	else
		TS_TRY(resolve_keyword(sim, keyword ? keyword : name, where, ref));
	ref->removals = sim->removals;
	return TS_OK;
}

/* Resolves the ref again if an instance has been deleted since it was resolved. */
static enum ts_status refresh_ref(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
				  struct ts_ref *now)
{
	*now = *ref;
	return ref->removals == sim->removals ? TS_OK : ts_ref_resolve(sim, ref->name, where, now);
}

/* The shape that the indices of the ref select from an output of this shape, as a bit; 0: none. */
static unsigned shape_with_indices(const struct ts_ref *ref, enum ts_shape shape)
{
	if (shape == TS_ARRAY && ref->index)
		return 1u << (ref->column ? TS_SCALAR : TS_VECTOR);
	if (ref->column || (shape == TS_SCALAR && ref->index))
		return 0;
	if (shape == TS_SURFACE)
		return 1u << TS_SURFACE | 1u << TS_LOCAL;
	return 1u << (shape == TS_VECTOR && ref->index ? TS_SCALAR : shape);
}

enum ts_status ts_ref_check_index(struct tsim *sim, const struct ts_ref *ref, unsigned shapes,
				  const struct ts_place *where)
{
	const struct ts_instance *inst = ref->inst;
	size_t most = 0;

	if (!inst)
		return TS_OK;
	for (const struct ts_value *v = inst->style->values; v->name; v++) {
		const bool array = v->shape == TS_ARRAY;
		const long wanted = array && ref->column ? ref->column : ref->index;
		size_t width;

		if (!ts_value_given(inst, v) || !(shape_with_indices(ref, v->shape) & shapes))
			continue;
		width = ts_value_width(inst, v);
		if (width == 0 || wanted <= (long)width)
			return TS_OK;
		most = width > most ? width : most;
	}
	if (!most) /* told by what reads it */
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, where, "'%s': %s %s (%s) has no [%ld], the last is [%zu]",
		       ref->name, ts_kind_name(inst->style->kind), inst->id, inst->style->name,
		       ref->column ? ref->column : ref->index, most);
}

static unsigned shape_of_variable(const struct tsim *sim, const struct ts_ref *ref)
{
	if (sim->script_api->is_peratom(sim->script_api_data, ref->variable))
		return 1u << TS_PERATOM;
	if (sim->script_api->is_vector(sim->script_api_data, ref->variable) && !ref->index)
		return 1u << TS_VECTOR;
	return 1u << TS_SCALAR;
}

static struct ts_instance *find_instance_of_ref(const struct tsim *sim, const struct ts_ref *ref)
{
	char id[MOST_ID];
	long index, column;

	if (!parse_indices(ref->name + 2, id, sizeof id, &index, &column))
		return NULL;
	return ts_sim_find(sim, ref->kind == TS_REF_COMPUTE ? TS_KIND_COMPUTE : TS_KIND_FIX, id);
}

unsigned ts_ref_shapes(const struct tsim *sim, const struct ts_ref *ref)
{
	const struct ts_instance *inst;
	unsigned shapes = 0;

	if (ref->kind == TS_REF_KEYWORD)
		return 1u << TS_SCALAR | (ts_ref_standard_elements(sim, ref->name) ? 1u << TS_VECTOR : 0);
	if (ref->kind == TS_REF_VARIABLE)
		return shape_of_variable(sim, ref);
	if (ref->kind == TS_REF_COLUMN)
		return 1u << TS_PERATOM;
	inst = ref->inst;
	if (ref->removals != sim->removals)
		inst = find_instance_of_ref(sim, ref);
	for (const struct ts_value *v = inst ? inst->style->values : NULL; v && v->name; v++)
		if (ts_value_given(inst, v))
			shapes |= shape_with_indices(ref, v->shape);
	return shapes;
}

static enum ts_status fail_no_output(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
				     const char *wanted)
{
	return ts_fail(&sim->error, TS_STATE, where, "%s %s (style %s) has no %s output",
		       ts_kind_name(ref->inst->style->kind), ref->inst->id, ref->inst->style->name, wanted);
}

/* The column that the index of the ref selects; *column counts from 0. */
static enum ts_status pick_column(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
				  size_t columns, size_t *column)
{
	if (ref->index > (long)columns)
		return ts_fail(&sim->error, TS_RANGE, where, "%s %s: column [%ld] asked for, it has %zu",
			       ts_kind_name(ref->inst->style->kind), ref->inst->id, ref->index, columns);
	if (!ref->index && columns > 1)
		return ts_fail(&sim->error, TS_SYNTAX, where, "%s %s has %zu columns, choose one with [k]",
			       ts_kind_name(ref->inst->style->kind), ref->inst->id, columns);
	*column = ref->index ? (size_t)ref->index - 1 : 0;
	return TS_OK;
}

/* [i][j] of an array. */
static enum ts_status element_of_array(struct tsim *sim, const struct ts_ref *ref,
				       const struct ts_place *where, double *out)
{
	const struct ts_value *value = ts_value_find(ref->inst, TS_ARRAY);
	struct ts_table *table = &ref->inst->table;

	if (!value)
		return fail_no_output(sim, ref, where, "array");
	TS_TRY(ts_value_cached(ref->inst, sim, value));
	if (ref->index > (long)table->rows || ref->column > (long)table->columns)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "%s %s: element [%ld][%ld] asked for, the array has %zu rows and %zu columns",
			       ts_kind_name(ref->inst->style->kind), ref->inst->id, ref->index, ref->column,
			       table->rows, table->columns);
	*out = table->data[(size_t)(ref->index - 1) * table->columns + (size_t)ref->column - 1];
	return TS_OK;
}

static enum ts_status scalar_of_instance(struct tsim *sim, const struct ts_ref *ref,
					 const struct ts_place *where, double *out)
{
	enum ts_shape shape = ref->index ? TS_VECTOR : TS_SCALAR;
	const struct ts_value *value = ts_value_find(ref->inst, shape);
	struct ts_table *table = &ref->inst->table;
	size_t count;

	if (!value)
		return fail_no_output(sim, ref, where, ref->index ? "vector" : "scalar (use an index [k]?)");
	TS_TRY(ts_value_cached(ref->inst, sim, value));
	count = table->rows * table->columns;
	if (ref->index > (long)count)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "%s %s: element [%ld] asked for, the vector has %zu",
			       ts_kind_name(ref->inst->style->kind), ref->inst->id, ref->index, count);
	*out = table->data[ref->index ? ref->index - 1 : 0];
	return TS_OK;
}

static enum ts_status scalar_of_variable(struct tsim *sim, const struct ts_ref *ref,
					 const struct ts_place *where, double *out)
{
	struct ts_table table = { 0 };
	enum ts_status status;

	if (!ref->index)
		return sim->script_api->scalar(sim->script_api_data, ref->variable, where, out);
	status = sim->script_api->vector(sim->script_api_data, ref->variable, where, &table);
	if (status == TS_OK && (size_t)ref->index > table.rows)
		status = ts_fail(&sim->error, TS_RANGE, where,
				 "element [%ld] asked for, variable '%s' has %zu", ref->index, ref->variable,
				 table.rows);
	if (status == TS_OK)
		*out = table.data[ref->index - 1];
	ts_table_release(&table);
	return status;
}

static enum ts_status fail_peratom(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where)
{
	return ts_fail(&sim->error, TS_STATE, where,
		       "'%s' has a value for each particle, one number is needed here; see compute reduce",
		       ref->name);
}

enum ts_status ts_ref_scalar(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
			     double *out)
{
	struct ts_ref now;

	switch (ref->kind) {
	case TS_REF_KEYWORD:
		return ref->keyword->eval(sim, out);
	case TS_REF_VARIABLE:
		return scalar_of_variable(sim, ref, where, out);
	case TS_REF_COLUMN:
		return fail_peratom(sim, ref, where);
	case TS_REF_COMPUTE:
	case TS_REF_FIX:
		break;
	}
	TS_TRY(refresh_ref(sim, ref, where, &now));
	if (!now.inst)
		return fail_peratom(sim, ref, where);
	return now.column ? element_of_array(sim, &now, where, out)
			  : scalar_of_instance(sim, &now, where, out);
}

enum ts_status ts_ref_check(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where)
{
	const struct ts_script_api *api = sim->script_api;
	void *data = sim->script_api_data;

	if (ref->kind == TS_REF_KEYWORD)
		return ts_keyword_check(sim, ref->keyword, where);
	if (ref->kind != TS_REF_VARIABLE)
		return TS_OK;
	return api->check_variable(data, ref->variable,
				   api->is_vector(data, ref->variable)	  ? TS_VECTOR
				   : api->is_peratom(data, ref->variable) ? TS_PERATOM
									  : TS_SCALAR,
				   where);
}

static enum ts_status copy_column(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
				  enum ts_shape shape, struct ts_table *out)
{
	const struct ts_value *value = ts_value_find(ref->inst, shape);
	const struct ts_table *table = &ref->inst->table;
	size_t column = 0;

	if (!value)
		return fail_no_output(sim, ref, where,
				      shape == TS_LOCAL	  ? "local"
				      : shape == TS_ARRAY ? "array"
							  : "per-particle");
	TS_TRY(ts_value_cached(ref->inst, sim, value));
	TS_TRY(pick_column(sim, ref, where, table->columns, &column));
	if (ts_table_resize(out, table->rows, 1) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < table->rows; i++)
		out->data[i] = table->data[i * table->columns + column];
	return TS_OK;
}

static enum ts_status copy_table(struct tsim *sim, struct ts_instance *inst, const struct ts_value *value,
				 struct ts_table *out)
{
	const struct ts_table *table = &inst->table;

	TS_TRY(ts_value_cached(inst, sim, value));
	if (ts_table_resize(out, table->rows, table->columns) != TS_OK)
		return ts_nomem(&sim->error);
	if (table->rows && table->columns)
		memcpy(out->data, table->data, table->rows * table->columns * sizeof *out->data);
	return TS_OK;
}

static enum ts_status repeat_scalar(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
				    struct ts_table *out)
{
	double value;

	TS_TRY(ts_quantity_eval(sim, "id", out)); /* a row for each local particle */
	TS_TRY(ts_ref_scalar(sim, ref, where, &value));
	for (size_t i = 0; i < out->rows; i++)
		out->data[i] = value;
	return TS_OK;
}

enum ts_status ts_ref_peratom(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
			      struct ts_table *out)
{
	struct ts_ref now;

	if (ref->kind != TS_REF_VARIABLE)
		TS_TRY(refresh_ref(sim, ref, where, &now));
	if (ref->kind != TS_REF_VARIABLE && now.kind == TS_REF_COLUMN)
		return ts_quantity_eval(sim, now.quantity, out);
	if (!(ts_ref_shapes(sim, ref) & (1u << TS_PERATOM)))
		return repeat_scalar(sim, ref, where, out);
	if (ref->kind == TS_REF_VARIABLE)
		return sim->script_api->peratom(sim->script_api_data, ref->variable, where, out);
	return copy_column(sim, &now, where, TS_PERATOM, out);
}

/* c_thermo_press: its n elements are keywords. */
static enum ts_status standard_vector(struct tsim *sim, const struct ts_ref *ref, size_t n,
				      const struct ts_place *where, struct ts_table *out)
{
	TS_TRY(ts_table_resize(out, n, 1));
	for (size_t k = 0; k < n; k++) {
		struct ts_ref element;
		char name[32];

		snprintf(name, sizeof name, "%s[%zu]", ref->name, k + 1);
		TS_TRY(ts_ref_resolve(sim, name, where, &element));
		TS_TRY(ts_ref_scalar(sim, &element, where, &out->data[k]));
	}
	return TS_OK;
}

enum ts_status ts_ref_vector(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
			     struct ts_table *out)
{
	const size_t standard = ref->inst ? 0 : ts_ref_standard_elements(sim, ref->name);
	const struct ts_value *value;
	struct ts_ref now;

	if (standard)
		return standard_vector(sim, ref, standard, where, out);
	if (ref->kind == TS_REF_VARIABLE)
		return sim->script_api->vector(sim->script_api_data, ref->variable, where, out);
	TS_TRY(refresh_ref(sim, ref, where, &now));
	if (now.inst && now.index)
		return copy_column(sim, &now, where, TS_ARRAY, out);
	value = now.inst ? ts_value_find(now.inst, TS_VECTOR) : NULL;
	if (!value)
		return ts_fail(&sim->error, TS_STATE, where,
			       "expected a compute or fix with a vector output, or a variable of style "
			       "vector");
	return copy_table(sim, now.inst, value, out);
}

enum ts_status ts_ref_local(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
			    struct ts_table *out)
{
	struct ts_ref now;

	TS_TRY(refresh_ref(sim, ref, where, &now));
	if (!now.inst)
		return ts_fail(&sim->error, TS_STATE, where, "expected a compute or fix with a local output");
	return copy_column(sim, &now, where, TS_LOCAL, out);
}
