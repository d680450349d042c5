/* Functions of a whole vector, such as the record of a fix: slope(f_trace[2]); and functions of
 * groups, whose arguments are names. */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "math/fit.h"
#include "script/expr.h"

#include "base/banned.h"

struct ts_series_function {
	const char *name;
	size_t least; /* numbers it needs */
	enum ts_status (*eval)(const double *x, size_t n, double *out);
};

static enum ts_status eval_sum(const double *x, size_t n, double *out)
{
	*out = 0;
	for (size_t i = 0; i < n; i++)
		*out += x[i];
	return TS_OK;
}

static enum ts_status eval_ave(const double *x, size_t n, double *out)
{
	eval_sum(x, n, out);
	*out /= (double)n;
	return TS_OK;
}

static enum ts_status eval_min(const double *x, size_t n, double *out)
{
	*out = x[0];
	for (size_t i = 1; i < n; i++)
		*out = fmin(*out, x[i]);
	return TS_OK;
}

static enum ts_status eval_max(const double *x, size_t n, double *out)
{
	*out = x[0];
	for (size_t i = 1; i < n; i++)
		*out = fmax(*out, x[i]);
	return TS_OK;
}

/* Trapezoidal rule with unit spacing. */
static enum ts_status eval_trap(const double *x, size_t n, double *out)
{
	eval_sum(x, n, out);
	*out -= 0.5 * (x[0] + x[n - 1]);
	return TS_OK;
}

static enum ts_status eval_slope(const double *x, size_t n, double *out)
{
	struct ts_fit fit;

	TS_TRY(ts_fit_line(NULL, x, n, &fit));
	*out = fit.slope;
	return TS_OK;
}

static enum ts_status eval_stderr(const double *x, size_t n, double *out)
{
	struct ts_fit fit;

	TS_TRY(ts_fit_line(NULL, x, n, &fit));
	*out = fit.slope_error;
	return TS_OK;
}

static const struct ts_series_function functions[] = {
	{ "sum", 0, eval_sum },	      { "ave", 1, eval_ave },	{ "min", 1, eval_min },
	{ "max", 1, eval_max },	      { "trap", 2, eval_trap }, { "slope", 2, eval_slope },
	{ "stderr", 3, eval_stderr }, /* of the slope */
};
enum { NFUNCTIONS = sizeof functions / sizeof *functions, MOST = 8 };

const struct ts_series_function *ts_series_function_find(const char *name)
{
	for (size_t k = 0; k < NFUNCTIONS; k++)
		if (ts_streq(functions[k].name, name))
			return &functions[k];
	return NULL;
}

void ts_series_function_suggest(struct ts_suggest *suggest)
{
	for (size_t k = 0; k < NFUNCTIONS; k++)
		ts_suggest_try(suggest, functions[k].name);
}

/* The texts between the commas up to the closing bracket; e->at ends behind it. */
static enum ts_status read_words(struct ts_expr *e, size_t at, struct ts_word *word, size_t *n)
{
	int depth = 0;

	*n = 0;
	do {
		size_t first = ++e->at, end;

		for (; e->text[e->at]; e->at++) {
			char c = e->text[e->at];

			if (!depth && (c == ',' || c == ')'))
				break;
			depth += (c == '(' || c == '[') - (c == ')' || c == ']');
		}
		if (!e->text[e->at])
			return ts_expr_fail(e, TS_SYNTAX, at, e->length, "'(' is never closed");
		end = e->at;
		while (first < end && isspace((unsigned char)e->text[first]))
			first++;
		while (first < end && isspace((unsigned char)e->text[end - 1]))
			end--;
		if (*n == MOST)
			return ts_expr_fail(e, TS_SYNTAX, first, end, "too many arguments");
		if (first == end && (*n || e->text[e->at] == ','))
			return ts_expr_fail(e, TS_SYNTAX, e->at, e->at + 1,
					    "an argument is missing before this");
		word[*n].text = ts_expr_copy(e, first, end);
		word[*n].place = ts_place_inside(e->place, e->length, first, end - first);
		if (!word[*n].text)
			return TS_NOMEM;
		*n += first < end;
	} while (e->text[e->at] == ',');
	e->at++;
	return TS_OK;
}

/* A whole vector; or the column of a table that c_ID[k] names. */
static enum ts_status read_series(struct ts_expr *e, const struct ts_word *word,
				  struct ts_table *out)
{
	struct ts_ref ref;
	unsigned shapes;

	TS_TRY(ts_ref_resolve(e->sim, word->text, &word->place, &ref));
	if (ref.kind != TS_REF_COMPUTE && ref.kind != TS_REF_FIX)
		return ts_fail(&e->sim->error, TS_SYNTAX, &word->place,
			       "expected the vector of a compute or fix (c_ID or f_ID), found '%s'",
			       word->text);
	shapes = ts_ref_shapes(e->sim, &ref);
	if (shapes & (1u << TS_VECTOR))
		return ts_ref_vector(e->sim, &ref, &word->place, out);
	if (shapes & (1u << TS_LOCAL))
		return ts_ref_local(e->sim, &ref, &word->place, out);
	if (shapes & (1u << TS_PERATOM))
		return ts_ref_peratom(e->sim, &ref, &word->place, out);
	return ts_ref_vector(e->sim, &ref, &word->place, out);
}

enum ts_status ts_series_function_call(struct ts_expr *e, const struct ts_series_function *f,
				       size_t at, struct ts_operand *out)
{
	struct ts_word word[MOST] = { 0 };
	struct ts_table table = { 0 };
	enum ts_status status;
	size_t n;

	TS_TRY(read_words(e, at, word, &n));
	if (n != 1)
		return ts_expr_fail(e, TS_SYNTAX, at, e->at, "%s(x) takes 1 argument, found %zu",
				    f->name, n);
	status = ts_expr_blame(e, read_series(e, &word[0], &table), at, e->at);
	n = table.rows * table.columns;
	if (status == TS_OK && n < f->least && e->sim->explain) {
		out->scalar = 0; /* nothing has been run that could fill the series */
	} else if (status == TS_OK && n < f->least) {
		status = ts_expr_fail(e, TS_RANGE, at, e->at,
				      "%s needs at least %zu numbers, '%s' has %zu", f->name,
				      f->least, word[0].text, n);
	} else if (status == TS_OK) {
		status = f->eval(table.data, n, &out->scalar);
	}
	if (status == TS_OK && !isfinite(out->scalar))
		status = TS_RANGE;
	if (status == TS_RANGE) /* the first message stays */
		ts_expr_fail(e, TS_RANGE, at, e->at, "%s(%s) has no finite value", f->name,
			     word[0].text);
	ts_table_release(&table);
	return status == TS_NOMEM ? ts_nomem(&e->sim->error) : status;
}

enum ts_status ts_group_function_call(struct ts_expr *e, const struct ts_function *f, size_t at,
				      struct ts_operand *out)
{
	struct ts_word word[MOST] = { 0 };
	enum ts_status status;
	size_t n;

	TS_TRY(read_words(e, at, word, &n));
	if (n < f->least || n > f->most)
		return ts_expr_fail(e, TS_SYNTAX, at, e->at,
				    "%s(%s) takes %zu to %zu arguments, "
				    "found %zu",
				    f->name, f->arguments, f->least, f->most, n);
	status = f->eval(e->sim, (struct ts_words){ word, n }, &out->scalar);
	if (status == TS_OK && !isfinite(out->scalar))
		return ts_expr_fail(e, TS_RANGE, at, e->at, "%s has no finite value", f->name);
	return ts_expr_blame(e, status, at, e->at);
}
