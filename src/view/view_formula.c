/* Formulas of columns, such as `100*v_a/c_b` and `$2/$3`, as further columns of the tables. */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "core/script_api.h"
#include "view/internal.h"

#include "base/banned.h"

/* Columns that a formula names, and the formula with variables in their place. */
struct formula {
	const char *text;
	size_t column[TS_SCRIPT_ROWS], n;
	struct ts_str script;
};

static bool is_part_of_name(char c)
{
	return isalnum((unsigned char)c) || c == '_' || c == '[';
}

bool ts_view_is_formula(const char *text)
{
	return strpbrk(text, "+-*/^%($") != NULL;
}

/* The column whose name, the longest, stands at the beginning of the text. *n: its length. */
static size_t find_longest(const struct ts_sheet *t, const char *text, size_t *n)
{
	size_t found = SIZE_MAX;

	*n = 0;
	for (size_t k = 0; k < t->columns; k++) {
		const char *name = t->column[k].name;
		size_t length = strlen(name);

		if (length > *n && !isdigit((unsigned char)name[0]) && strncmp(text, name, length) == 0 &&
		    !(is_part_of_name(name[length - 1]) && is_part_of_name(text[length]))) {
			found = k;
			*n = length;
		}
	}
	return found;
}

/* $N: the column number N. */
static size_t find_numbered(const struct ts_sheet *t, const char *text, size_t *n)
{
	size_t number = 0;

	for (*n = 1; isdigit((unsigned char)text[*n]) && number < t->columns; ++*n)
		number = 10 * number + (size_t)(text[*n] - '0');
	return *n > 1 && number >= 1 && number <= t->columns && !isdigit((unsigned char)text[*n]) ? number - 1
												  : SIZE_MAX;
}

static enum ts_status use_column(const struct ts_view_data *v, const struct ts_view_file *f,
				 struct formula *of, size_t column)
{
	const struct ts_sheet_column *c = &f->part[0]->column[column];
	size_t k = 0;

	while (k < of->n && of->column[k] != column)
		k++;
	if (k == TS_SCRIPT_ROWS)
		return ts_fail(&v->sim->error, TS_RANGE, NULL, "'%s': a formula has at most %d columns",
			       of->text, TS_SCRIPT_ROWS);
	if (c->text)
		return ts_fail(&v->sim->error, TS_SYNTAX, NULL,
			       "'%s': column '%s' of %s has '%.60s', expected a number", of->text, c->name,
			       f->source->path, c->text);
	if (k == of->n)
		of->column[of->n++] = column;
	ts_str_addf(&of->script, "v_column_%zu", column + 1);
	return TS_OK;
}

/* Replaces the names of columns. Other names are those of functions and constants. */
static enum ts_status read_formula(const struct ts_view_data *v, const struct ts_view_file *f,
				   struct formula *of)
{
	const struct ts_sheet *t = f->part[0];
	const char *at = of->text;

	while (*at) {
		size_t n, column = *at == '$' ? find_numbered(t, at, &n) : find_longest(t, at, &n);

		if (*at == '$' && column == SIZE_MAX)
			return ts_fail(&v->sim->error, TS_RANGE, NULL,
				       "'%s': the columns of %s are $1 to $%zu", of->text, f->source->path,
				       t->columns);
		if (column != SIZE_MAX) {
			TS_TRY(use_column(v, f, of, column));
			at += n;
			continue;
		}
		do
			ts_str_add_n(&of->script, at++, 1);
		while (*at && is_part_of_name(at[-1]) && is_part_of_name(*at));
	}
	if (of->script.failed)
		return ts_nomem(&v->sim->error);
	return of->n ? TS_OK
		     : ts_fail(&v->sim->error, TS_UNKNOWN, NULL,
			       "%s has no column '%s', and as a formula it names none", f->source->path,
			       of->text);
}

/* Its text outlives the tables, as an error is printed after they are gone. */
static struct ts_place place_of(const struct ts_view_data *v, const struct formula *of)
{
	return (struct ts_place){ .file = "-plot", .text = ts_pool_get(v->sim->pool, of->text), .line = 1 };
}

/* Defines the variables of the formula. */
static enum ts_status define_variables(const struct ts_view_data *v, const struct formula *of)
{
	struct ts_place where = place_of(v, of);
	struct ts_str line = { 0 };
	enum ts_status status;

	for (size_t k = 0; k < of->n; k++)
		ts_str_addf(&line, "variable column_%zu internal 0\n", of->column[k] + 1);
	ts_str_addf(&line, "variable of_columns delete\nvariable of_columns equal \"%s\"",
		    ts_str_text(&of->script));
	status = line.failed
			 ? ts_nomem(&v->sim->error)
			 : v->sim->script_api->execute(v->sim->script_api_data, ts_str_text(&line), &where);
	ts_str_release(&line);
	return status;
}

/* Row by row, where some have no value, such as a division by 0: they are not known. *known: how many have one. */
static enum ts_status evaluate_rows(const struct ts_view_data *v, const struct ts_place *where,
				    const struct ts_script_rows *rows, size_t nrows, size_t n, double *out,
				    size_t *known)
{
	struct ts_script_rows one[TS_SCRIPT_ROWS];

	for (size_t row = 0; row < n; row++) {
		enum ts_status status;

		for (size_t k = 0; k < nrows; k++)
			one[k] = (struct ts_script_rows){ rows[k].internal, rows[k].row + row };
		status = v->sim->script_api->columns(v->sim->script_api_data, "of_columns", where, one, nrows,
						     1, &out[row]);
		if (status == TS_SYNTAX || status == TS_UNKNOWN || status == TS_NOMEM || status == TS_STOPPED)
			return status;
		if (status != TS_OK)
			out[row] = NAN;
		*known += status == TS_OK;
		ts_error_clear(&v->sim->error);
	}
	return TS_OK;
}

static enum ts_status evaluate(const struct ts_view_data *v, const struct ts_place *where,
			       const struct ts_script_rows *rows, size_t nrows, size_t n, double *out)
{
	size_t known = 0;
	enum ts_status status = v->sim->script_api->columns(v->sim->script_api_data, "of_columns", where,
							    rows, nrows, n, out);

	if (status == TS_OK || status == TS_SYNTAX || status == TS_UNKNOWN || status == TS_NOMEM ||
	    status == TS_STOPPED)
		return status;
	ts_error_clear(&v->sim->error);
	TS_TRY(evaluate_rows(v, where, rows, nrows, n, out, &known));
	return known ? TS_OK : /* for its message */
		       v->sim->script_api->columns(v->sim->script_api_data, "of_columns", where, rows, nrows,
						   n, out);
}

/* A table with a further column. */
static enum ts_status add_column(const struct ts_view_data *v, struct ts_sheets *sheets, struct ts_sheet *t,
				 const struct formula *of)
{
	struct ts_place where = place_of(v, of);
	struct ts_sheet_column *column = ts_arena_alloc(&sheets->arena, t->columns + 1, sizeof *column);
	struct ts_script_rows rows[TS_SCRIPT_ROWS];
	char name[TS_SCRIPT_ROWS][32];

	if (!column)
		return ts_nomem(&v->sim->error);
	memcpy(column, t->column, t->columns * sizeof *column);
	column[t->columns] = (struct ts_sheet_column){ .name = ts_arena_strdup(&sheets->arena, of->text) };
	if (!column[t->columns].name || !(column[t->columns].value = ts_alloc(t->rows + 1, sizeof(double))))
		return ts_nomem(&v->sim->error);
	for (size_t k = 0; k < of->n; k++) {
		snprintf(name[k], sizeof name[k], "column_%zu", of->column[k] + 1);
		rows[k] = (struct ts_script_rows){ name[k], t->column[of->column[k]].value };
	}
	t->column = column;
	t->columns++; /* from now on the values are freed with the table */
	return t->rows ? evaluate(v, &where, rows, of->n, t->rows, column[t->columns - 1].value) : TS_OK;
}

enum ts_status ts_view_add_formula(const struct ts_view_data *v, struct ts_view_file *f, const char *text,
				   size_t *column)
{
	struct formula of = { .text = text };
	enum ts_status status = read_formula(v, f, &of);

	*column = f->part[0]->columns;
	if (status == TS_OK)
		status = define_variables(v, &of);
	for (size_t p = 0; p < f->parts && status == TS_OK; p++)
		status = add_column(v, &f->sheets, &f->sheets.sheet[f->part[p] - f->sheets.sheet], &of);
	ts_str_release(&of.script);
	return status;
}
