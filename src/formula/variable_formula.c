/* Variables with a formula, evaluated each time they are used: equal, atom, vector. */
#include <string.h>

#include "formula/dry_run.h"
#include "formula/expr.h"

#include "base/banned.h"

static enum ts_status equal_number(struct ts_formulas *formulas, struct ts_variable *variable,
				   const struct ts_place *where, double *out)
{
	const struct ts_word *formula = &variable->values.word[0];
	uint64_t drawn = formulas->drawn;

	(void)where;
	if (formulas->depth && !formulas->rows && variable->evaluation == formulas->evaluation) {
		*out = variable->number;
		return TS_OK;
	}
	TS_TRY(ts_expr_scalar(formulas, formula->text, &formula->place, out));
	variable->number = *out;
	if (!formulas->rows) /* else it tells of the column that is kept */
		variable->evaluation = drawn == formulas->drawn ? formulas->evaluation : 0;
	return TS_OK;
}

static enum ts_status equal_text(struct ts_formulas *formulas, struct ts_variable *variable,
				 const struct ts_place *where, struct ts_str *out)
{
	double value = 0;

	TS_TRY(equal_number(formulas, variable, where, &value));
	ts_unknown_add(formulas->sim, out, "%.15g", value);
	return TS_OK;
}

typedef enum ts_status read_table(struct ts_formulas *formulas, const char *text,
				  const struct ts_place *place, struct ts_table *out);

static enum ts_status copy_table(struct ts_formulas *formulas, const struct ts_table *from,
				 struct ts_table *to)
{
	if (ts_table_resize(to, from->rows, from->columns) != TS_OK)
		return ts_nomem(&formulas->sim->error);
	if (from->rows)
		memcpy(to->data, from->data, from->rows * from->columns * sizeof *to->data);
	return TS_OK;
}

/* Within one evaluation each column and list is computed once, unless it has drawn random numbers. */
static enum ts_status evaluate_once(struct ts_formulas *formulas, struct ts_variable *variable,
				    read_table *read, struct ts_table *out)
{
	const struct ts_word *formula = &variable->values.word[0];
	bool inner = formulas->depth > 0;
	uint64_t drawn = formulas->drawn;

	if (inner && variable->evaluation == formulas->evaluation)
		return copy_table(formulas, &variable->kept, out);
	TS_TRY(read(formulas, formula->text, &formula->place, out));
	if (!inner || drawn != formulas->drawn)
		return TS_OK;
	TS_TRY(copy_table(formulas, out, &variable->kept));
	variable->evaluation = formulas->evaluation;
	variable->next_kept = formulas->kept;
	formulas->kept = variable;
	return TS_OK;
}

void ts_variables_release_cache(struct ts_formulas *formulas)
{
	for (struct ts_variable *v = formulas->kept; v; v = v->next_kept) {
		ts_table_release(&v->kept);
		v->evaluation = 0;
	}
	formulas->kept = NULL;
}

static enum ts_status formula_peratom(struct ts_formulas *formulas, struct ts_variable *variable,
				      const struct ts_place *where, struct ts_table *out)
{
	(void)where;
	return evaluate_once(formulas, variable, ts_expr_peratom, out);
}

/* Called only by styles that need a value for each particle; formulas use the number. */
static enum ts_status equal_peratom(struct ts_formulas *formulas, struct ts_variable *variable,
				    const struct ts_place *where, struct ts_table *out)
{
	const struct ts_word *formula = &variable->values.word[0];

	(void)where;
	return ts_expr_peratom(formulas, formula->text, &formula->place, out);
}

static enum ts_status equal_columns(struct ts_formulas *formulas, struct ts_variable *variable,
				    const struct ts_place *where, struct ts_table *out)
{
	(void)where;
	return evaluate_once(formulas, variable, ts_expr_columns, out);
}

static enum ts_status formula_vector(struct ts_formulas *formulas, struct ts_variable *variable,
				     const struct ts_place *where, struct ts_table *out)
{
	(void)where;
	return evaluate_once(formulas, variable, ts_expr_vector, out);
}

/* In the format of LAMMPS: [1,2.5,3] */
static enum ts_status vector_text(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, struct ts_str *out)
{
	struct ts_table table = { 0 };
	enum ts_status status = formula_vector(formulas, variable, where, &table);

	ts_str_add(out, "[");
	for (size_t k = 0; status == TS_OK && k < table.rows; k++) {
		ts_str_add(out, k ? "," : "");
		ts_unknown_add(formulas->sim, out, "%.15g", table.data[k]);
	}
	ts_str_add(out, "]");
	ts_table_release(&table);
	return status;
}

/* Checks the formula: outputs that exist must have the right shape, other names may be defined later. */
static enum ts_status check_formula(struct ts_formulas *formulas, struct ts_variable *variable,
				    read_table *read)
{
	const struct ts_word *formula = &variable->values.word[0];
	struct ts_dry_run before = ts_dry_run_begin(formulas);
	struct ts_table table = { 0 };
	enum ts_status status;
	double number;

	status = read ? read(formulas, formula->text, &formula->place, &table)
		      : ts_expr_scalar(formulas, formula->text, &formula->place, &number);
	ts_table_release(&table);
	return ts_dry_run_end(formulas, before, status, false);
}

static enum ts_status define_equal(struct ts_formulas *formulas, struct ts_variable *variable)
{
	return check_formula(formulas, variable, NULL);
}

static enum ts_status define_vector(struct ts_formulas *formulas, struct ts_variable *variable)
{
	return check_formula(formulas, variable, ts_expr_vector);
}

const struct ts_variable_style ts_var_equal = {
	.name = "equal",
	.values = "formula",
	.help = "a formula with one value",
	.least = 1,
	.most = 1,
	.define = define_equal,
	.text = equal_text,
	.number = equal_number,
	.peratom = equal_peratom,
	.columns = equal_columns,
};

const struct ts_variable_style ts_var_atom = {
	.name = "atom",
	.values = "formula",
	.help = "a formula with a value for each particle",
	.least = 1,
	.most = 1,
	.peratom = formula_peratom,
};

const struct ts_variable_style ts_var_vector = {
	.name = "vector",
	.values = "formula",
	.help = "a formula whose value is a list of numbers, such as f_trace or [1,2.5,4]",
	.least = 1,
	.most = 1,
	.define = define_vector,
	.text = vector_text,
	.vector = formula_vector,
};
