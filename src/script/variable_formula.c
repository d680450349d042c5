/* Variables that keep a formula, evaluated each time they are used: equal, atom, vector. */
#include "script/unknown.h"

#include "base/banned.h"

static enum ts_status equal_number(struct ts_script *script, struct ts_variable *variable,
				   const struct ts_place *where, double *out)
{
	const struct ts_word *formula = &variable->values.word[0];

	(void)where;
	return ts_expr_scalar(script, formula->text, &formula->place, out);
}

static enum ts_status equal_text(struct ts_script *script, struct ts_variable *variable,
				 const struct ts_place *where, struct ts_str *out)
{
	double value = 0;

	TS_TRY(equal_number(script, variable, where, &value));
	ts_unknown_add(script->sim, out, "%.15g", value);
	return TS_OK;
}

static enum ts_status formula_peratom(struct ts_script *script, struct ts_variable *variable,
				      const struct ts_place *where, struct ts_table *out)
{
	const struct ts_word *formula = &variable->values.word[0];

	(void)where;
	return ts_expr_peratom(script, formula->text, &formula->place, out);
}

static enum ts_status formula_vector(struct ts_script *script, struct ts_variable *variable,
				     const struct ts_place *where, struct ts_table *out)
{
	const struct ts_word *formula = &variable->values.word[0];

	(void)where;
	return ts_expr_vector(script, formula->text, &formula->place, out);
}

/* As LAMMPS shows it: [1,2.5,3] */
static enum ts_status vector_text(struct ts_script *script, struct ts_variable *variable,
				  const struct ts_place *where, struct ts_str *out)
{
	struct ts_table table = { 0 };
	enum ts_status status = formula_vector(script, variable, where, &table);

	ts_str_add(out, "[");
	for (size_t k = 0; status == TS_OK && k < table.rows; k++) {
		ts_str_add(out, k ? "," : "");
		ts_unknown_add(script->sim, out, "%.15g", table.data[k]);
	}
	ts_str_add(out, "]");
	ts_table_release(&table);
	return status;
}

const struct ts_variable_style ts_var_equal = {
	.name = "equal",
	.values = "formula",
	.help = "a formula with one value",
	.least = 1,
	.most = 1,
	.text = equal_text,
	.number = equal_number,
	.peratom = formula_peratom,
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
	.text = vector_text,
	.vector = formula_vector,
};
