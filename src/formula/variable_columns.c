/* A formula for many values of variables of style internal, by columns. */
#include <string.h>

#include "formula/formulas.h"

#include "base/banned.h"

struct columns {
	struct ts_formulas *formulas;
	struct ts_variable *variable;
	const struct ts_place *where;
	const struct ts_variable_rows *set;
	size_t nset, n;
};

static void set_row(const struct columns *c, size_t k)
{
	for (size_t v = 0; v < c->nset; v++)
		c->set[v].internal->number = c->set[v].row[k];
	c->formulas->evaluation++; /* values computed with the old numbers are void */
}

static enum ts_status evaluate_row(const struct columns *c, size_t k, double *out)
{
	set_row(c, k);
	return ts_variable_number(c->formulas, c->variable, c->where, out);
}

static void set_columns(const struct columns *c, bool on)
{
	for (size_t v = 0; v < c->nset; v++)
		c->set[v].internal->column = on ? c->set[v].row : NULL;
	c->formulas->rows = on ? c->n : 0;
}

/* *done: no variable was used as a number that differs from row to row. */
static enum ts_status evaluate_rows(const struct columns *c, double *out, bool *done)
{
	struct ts_table table = { 0 };
	enum ts_status status;

	set_row(c, c->n - 1);
	set_columns(c, true);
	c->formulas->by_number = false;
	status = ts_variable_column(c->formulas, c->variable, c->where, &table);
	set_columns(c, false);
	*done = !c->formulas->by_number;
	if (status == TS_OK && *done)
		memcpy(out, table.data, c->n * sizeof *out);
	ts_table_release(&table);
	return status;
}

/* The first row alone shows whether the formula is correct, and whether it draws random numbers: these are drawn row by
 * row. -check and -explain, too, go row by row: they know values that are open. */
enum ts_status ts_variable_columns(struct ts_formulas *formulas, struct ts_variable *variable,
				   const struct ts_place *where, const struct ts_variable_rows *set,
				   size_t nset, size_t n, double *out)
{
	const struct columns c = { formulas, variable, where, set, nset, n };
	const uint64_t drawn = formulas->drawn;
	bool done = false;

	TS_TRY(evaluate_row(&c, 0, &out[0]));
	if (variable->style->columns && drawn == formulas->drawn && !formulas->depth &&
	    !formulas->sim->reading.dry && !formulas->sim->reading.explain)
		TS_TRY(evaluate_rows(&c, out, &done));
	for (size_t k = 1; k < n && !done; k++)
		TS_TRY(evaluate_row(&c, k, &out[k]));
	return TS_OK;
}
