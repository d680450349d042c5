/* Evaluation by name: formulas, outputs of computes and fixes, variables. */
#include "library/library.h"

#include <math.h>
#include <string.h>

#include "core/ranks.h"
#include "core/ranks_pause.h"
#include "script/script.h"

#include "base/banned.h"

#define SAME(shape) _Static_assert((int)TSIM_##shape == (int)TS_##shape, "shapes agree")
SAME(SCALAR);
SAME(VECTOR);
SAME(LOCAL);
SAME(ARRAY);
_Static_assert((int)TSIM_PER_PARTICLE == (int)TS_PERATOM, "shapes agree");

int tsim_value(struct tsim *sim, const char *formula, double *out)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, formula);
	TS_LIBRARY_NEEDS(sim, out);
	return ts_library_result(sim, ts_script_value(sim->script_api_data, formula, out));
}

static enum ts_status evaluate_output(struct tsim *sim, struct ts_instance *inst, enum ts_shape shape,
				      struct ts_table *out)
{
	static const char *const shapes[] = {
		[TSIM_PER_PARTICLE] = "per-particle", [TSIM_LOCAL] = "local", [TSIM_ARRAY] = "array"
	};
	const struct ts_value *value = ts_value_find(inst, shape);

	if (value)
		return ts_value_eval(inst, sim, value, out);
	return ts_fail(&sim->error, TS_STATE, NULL, "%s %s (style %s) has no %s output",
		       ts_kind_name(inst->style->kind), inst->id, inst->style->name, shapes[shape]);
}

static enum ts_status evaluate_reference(struct tsim *sim, const char *name, enum ts_shape shape,
					 struct ts_table *out)
{
	struct ts_ref ref;

	TS_TRY(ts_ref_resolve(sim, name, NULL, &ref));
	if (shape == TS_VECTOR) {
		TS_TRY(ts_ref_vector(sim, &ref, NULL, out));
		out->rows *= out->columns; /* a vector may be one row or one column */
		out->columns = 1;
		return TS_OK;
	}
	if (ref.inst && !ref.index)
		return evaluate_output(sim, ref.inst, shape, out);
	return shape == TS_LOCAL ? ts_ref_local(sim, &ref, NULL, out) : ts_ref_peratom(sim, &ref, NULL, out);
}

/* With several ranks, in a function of a step: of outputs only columns of particles are known, and numbers that the program
 * itself has given. */
static enum ts_status require_known(struct tsim *sim, const char *name, enum tsim_shape shape)
{
	const struct ts_word word = { .text = name };
	struct ts_ref ref;

	if (!sim->run.apart || !ts_ranks_find_shared(sim, (struct ts_words){ &word, 1 }))
		return TS_OK;
	TS_TRY(ts_ref_resolve(sim, name, NULL, &ref));
	if (ref.inst && ref.inst->style->kind == TS_KIND_FIX &&
	    (ref.inst->style->take ||
	     (shape == TSIM_PER_PARTICLE && ref.inst->style->ranks & TS_RANKS_OUTPUTS)))
		return TS_OK;
	return ts_ranks_require_all(sim, name, NULL);
}

static enum ts_status evaluate_shape(struct tsim *sim, const char *name, enum tsim_shape shape,
				     struct ts_table *out)
{
	TS_TRY(require_known(sim, name, shape));
	if (shape < TSIM_SCALAR || shape > TSIM_ARRAY)
		return ts_fail(&sim->error, TS_RANGE, NULL, "there is no shape %d", (int)shape);
	if (shape == TSIM_SCALAR) {
		if (ts_table_resize(out, 1, 1) != TS_OK)
			return ts_nomem(&sim->error);
		return ts_script_value(sim->script_api_data, name, out->data);
	}
	if (shape == TSIM_PER_PARTICLE && ts_quantity_has(sim, name))
		return ts_quantity_eval(sim, name, out);
	return evaluate_reference(sim, name, (enum ts_shape)shape, out);
}

int tsim_evaluate(struct tsim *sim, const char *name, enum tsim_shape shape, struct tsim_table *out)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS(sim, out);

	struct ts_table *table = &sim->library->table;
	enum ts_status status = evaluate_shape(sim, name, shape, table);
	const struct tsim_table full = { 0, table->data, table->rows, table->columns };

	if (status == TS_OK)
		ts_library_copy_struct(out, &full, sizeof full);
	return ts_library_result(sim, status);
}

int tsim_read(struct tsim *sim, const char *name, enum tsim_shape shape, double *out, size_t rows,
	      size_t columns)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS_ARRAY(sim, out, rows && columns);

	struct ts_table *table = &sim->library->table;
	enum ts_status status = evaluate_shape(sim, name, shape, table);

	if (status == TS_OK && (rows != table->rows || columns != table->columns))
		status = ts_fail(&sim->error, TS_RANGE, NULL,
				 "%s has %zu rows and %zu columns, the array %zu and %zu", name, table->rows,
				 table->columns, rows, columns);
	if (status == TS_OK && rows && columns)
		memcpy(out, table->data, rows * columns * sizeof *out);
	return ts_library_result(sim, status);
}

int tsim_extent(struct tsim *sim, const char *name, enum tsim_shape shape, size_t *rows, size_t *columns)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS(sim, rows);
	TS_LIBRARY_NEEDS(sim, columns);

	struct ts_table *table = &sim->library->table;
	enum ts_status status = evaluate_shape(sim, name, shape, table);

	*rows = status == TS_OK ? table->rows : 0;
	*columns = status == TS_OK ? table->columns : 0;
	return ts_library_result(sim, status);
}

int tsim_output(struct tsim *sim, const char *name, size_t k, struct tsim_output *out)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS(sim, out);

	struct ts_ref ref;
	enum ts_status status = ts_ref_resolve(sim, name, NULL, &ref);
	const struct ts_value *value;
	struct tsim_output full;

	if (status != TS_OK)
		return ts_library_result(sim, status);
	for (value = ref.inst ? ref.inst->style->values : NULL; value && value->name; value++)
		if (ts_value_given(ref.inst, value) && k-- == 0)
			break;
	if (!value || !value->name)
		return (int)ts_fail(&sim->error, TS_UNKNOWN, NULL, "%s has no more outputs", name);
	full = (struct tsim_output){ .name = value->name,
				     .unit = value->unit ? value->unit : "",
				     .help = value->help ? value->help : "",
				     .shape = (int)value->shape,
				     .columns = value->shape == TS_SCALAR ? 1 : value->columns,
				     .column_names = value->column_names };
	ts_library_copy_struct(out, &full, sizeof full);
	return TSIM_OK;
}

/* Variables may stand in arguments of styles, so forces may depend on them. */
static enum ts_status watch_changes(struct tsim *sim)
{
	return sim->run.inside ? TS_OK : ts_stepping_watch(&sim->library->stepping, sim);
}

int tsim_variable(struct tsim *sim, const char *name, const char *value)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS(sim, value);

	enum ts_status status = watch_changes(sim);

	if (status == TS_OK)
		status = ts_script_set_variable(sim->script_api_data, name, &value, 1, "variable");
	return ts_library_result(sim, status);
}

static enum ts_status define_variable(struct tsim *sim, const char *name, const char *style,
				      const char *value)
{
	TS_TRY(watch_changes(sim));
	return ts_script_define_variable(sim->script_api_data, name, style, value);
}

int tsim_variable_set(struct tsim *sim, const char *name, const char *style, const char *value)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS(sim, style);
	TS_LIBRARY_NEEDS(sim, value);
	return ts_library_result(sim, define_variable(sim, name, style, value));
}

int tsim_variable_number(struct tsim *sim, const char *name, double value)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);

	char text[32];

	if (!isfinite(value))
		return (int)ts_fail(&sim->error, TS_RANGE, NULL,
				    "variable '%s' would be %g, expected a finite number", name, value);
	snprintf(text, sizeof text, "%.17g", value);
	return ts_library_result(sim, define_variable(sim, name, "equal", text));
}

int tsim_variable_text(struct tsim *sim, const char *name, char *out, size_t room, size_t *length)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS_ARRAY(sim, out, room);

	struct ts_str wanted = { 0 }, text = { 0 };
	enum ts_status status;

	ts_str_addf(&wanted, "${%s}", name);
	status = wanted.failed ? ts_nomem(&sim->error)
			       : sim->script_api->substitute(sim->script_api_data, ts_str_text(&wanted), NULL,
							     &text);
	if (status == TS_OK && text.failed)
		status = ts_nomem(&sim->error);
	if (status == TS_OK)
		ts_library_copy(ts_str_text(&text), out, room, length);
	ts_str_release(&wanted);
	ts_str_release(&text);
	return ts_library_result(sim, status);
}

const char *tsim_variable_name(struct tsim *sim, size_t k)
{
	return sim ? ts_script_variable_name(sim->script_api_data, k) : NULL;
}
