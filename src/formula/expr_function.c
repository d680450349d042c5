/* Calls of functions. */
#include <math.h>
#include <string.h>

#include "core/ranks_pause.h"
#include "formula/expr.h"

#include "base/banned.h"

const struct ts_expr_function *const ts_expr_functions[] = { ts_math_functions, ts_step_functions,
							     ts_series_functions, ts_special_functions,
							     NULL };

const struct ts_expr_function *ts_expr_function_find(const char *name)
{
	for (const struct ts_expr_function *const *table = ts_expr_functions; *table; table++)
		for (const struct ts_expr_function *f = *table; f->name; f++)
			if (ts_streq(f->name, name))
				return f;
	return NULL;
}

static enum ts_status check_value(struct ts_expr *e, const struct ts_expr_function *f, size_t at, double x,
				  double value)
{
	if (isfinite(value))
		return TS_OK;
	return ts_expr_fail(e, TS_RANGE, at, e->at, "%s is %s, for %s = %.6g", f->name,
			    isnan(value) ? "not a real number" : "infinite", f->arguments, x);
}

static enum ts_status call_scalar(struct ts_expr *e, const struct ts_expr_function *f, size_t at,
				  const double *arg, double *out)
{
	bool open = false;

	for (size_t k = 0; k < (f->lazy ? 1 : f->most); k++)
		open |= ts_unknown(e->sim, arg[k]);
	if (open) {
		*out = NAN;
		return TS_OK;
	}
	if (f->pure)
		*out = f->pure(arg[0]);
	else
		TS_TRY(ts_expr_locate_error(e, f->eval(e, arg, out), at, e->at));
	return f->lazy && ts_unknown(e->sim, *out) ? TS_OK : check_value(e, f, at, arg[0], *out);
}

/* One number if all arguments are numbers, else one for each element of the lists among them. */
static enum ts_status call_elementwise(struct ts_expr *e, const struct ts_expr_function *f, size_t at,
				       const struct ts_operand *arg, struct ts_operand *out)
{
	double number[TS_MOST_ARGUMENTS] = { 0 };
	const struct ts_operand *list = NULL;

	for (size_t k = 0; k < f->most; k++) {
		number[k] = arg[k].scalar;
		if (arg[k].data && list && list->n != arg[k].n)
			return ts_expr_fail(e, TS_RANGE, at, e->at,
					    "lists of %zu and %zu numbers cannot be combined", list->n,
					    arg[k].n);
		if (arg[k].data)
			list = &arg[k];
	}
	if (!list)
		return call_scalar(e, f, at, number, &out->scalar);
	TS_TRY(ts_expr_array(e, list->n, out));
	for (size_t i = 0; i < out->n; i++) {
		for (size_t k = 0; k < f->most; k++)
			number[k] = arg[k].data ? arg[k].data[i] : arg[k].scalar;
		TS_TRY(call_scalar(e, f, at, number, &out->data[i]));
	}
	return TS_OK;
}

/* The counter of a counter-based random number (math/rng.h): in a run a hash of step, instance, stage and
 * number of draws in this step, so that runs can be cut anywhere; outside of runs draws are counted in
 * *taken. */
static uint64_t next_draw(struct tsim *sim, int64_t *taken)
{
	const int64_t when[] = { sim->era, sim->clock.step };
	struct ts_draws *draws = &sim->draws;
	struct ts_hash hash = ts_hash_start();

	if (!draws->site)
		return (uint64_t)(*taken)++;
	ts_hash_add(&hash, draws, sizeof *draws);
	ts_hash_add(&hash, when, sizeof when);
	draws->count++;
	return ts_hash_value(&hash);
}

/* Functions that draw random numbers, whose key is the seed. In formulas of particles the identity of the
 * particle is part of the key, so that numbers do not depend on the order of storage. */
static enum ts_status call_random(struct ts_expr *e, const struct ts_expr_function *f, size_t at,
				  const struct ts_operand *arg, struct ts_operand *out)
{
	bool each = e->kind == TS_FORMULA_PERATOM;
	double number[TS_MOST_ARGUMENTS] = { 0 };
	struct ts_random_stream *stream;
	size_t n = 1;
	double *to = &out->scalar;
	uint64_t at_number;

	for (size_t k = 0; k < f->most; k++)
		if (!arg[k].data && ts_unknown(e->sim, arg[k].scalar)) {
			out->scalar = NAN;
			return TS_OK;
		}
	for (size_t k = 0; k < f->most; k++)
		if (arg[k].data && (k + 1 == f->most || !each))
			return ts_expr_fail(e, TS_SYNTAX, arg[k].at, arg[k].end,
					    "one number is needed here, found a list");
	if (e->sim->reading.dry) {
		out->scalar = NAN;
		return TS_OK;
	}
	TS_TRY(ts_expr_locate_error(e, ts_random_stream_of(e->formulas, arg[f->most - 1].scalar, &stream), at,
				    e->at));
	if (each) {
		TS_TRY(ts_expr_array(e, e->rows, out));
		n = e->rows;
		to = out->data;
	}
	e->formulas->drawn++;
	at_number = next_draw(e->sim, each ? &stream->rounds : &stream->draws);
	for (size_t i = 0; i < n; i++) {
		struct ts_rng rng = { (uint64_t)stream->seed, each ? (uint64_t)e->id[i] : 0, at_number };

		for (size_t k = 0; k < f->most; k++)
			number[k] = arg[k].data ? arg[k].data[i] : arg[k].scalar;
		TS_TRY(ts_expr_locate_error(e, f->draw(e, number, &rng, &to[i]), at, e->at));
		TS_TRY(check_value(e, f, at, number[0], to[i]));
	}
	return TS_OK;
}

/* Whether an element of the list is unknown, or the list is too short because no run has filled it. */
static bool is_list_unknown(const struct ts_expr *e, const struct ts_expr_function *f,
			    const struct ts_operand *list)
{
	bool open = !list->data && ts_unknown(e->sim, list->scalar);

	for (size_t i = 0; list->data && i < list->n; i++)
		open |= ts_unknown(e->sim, list->data[i]);
	return open || e->sim->reading.dry ||
	       (list->data && list->n < f->length && e->sim->reading.explain && e->sim->reading.planned);
}

static enum ts_status call_on_list(struct ts_expr *e, const struct ts_expr_function *f, size_t at,
				   struct ts_operand *arg, struct ts_operand *out)
{
	size_t n = arg->n;
	enum ts_status status;

	if (is_list_unknown(e, f, arg)) {
		out->scalar = NAN;
		return TS_OK;
	}
	if (!arg->data)
		return ts_expr_fail(e, TS_SYNTAX, arg->at, arg->end,
				    "expected a list: the vector of a compute or fix, a variable of style "
				    "vector, or [1,2.5,3]");
	if (f->map) {
		f->map(arg->data, n);
		*out = *arg;
		return TS_OK;
	}
	if (n < f->length)
		return ts_expr_fail(e, TS_RANGE, at, e->at,
				    "%s needs at least %zu numbers, this list has %zu", f->name, f->length,
				    n);
	status = f->series(arg->data, n, &out->scalar);
	if (status == TS_RANGE || (status == TS_OK && !isfinite(out->scalar)))
		return ts_expr_fail(e, TS_RANGE, at, e->at, "%s of this list has no finite value", f->name);
	return status == TS_NOMEM ? ts_nomem(&e->sim->error) : status;
}

static enum ts_status call_on_words(struct ts_expr *e, const struct ts_expr_function *f, size_t at,
				    struct ts_operand *out)
{
	struct ts_word word[TS_MOST_ARGUMENTS] = { 0 };
	size_t n;

	TS_TRY(ts_expr_words(e, at, word, TS_MOST_ARGUMENTS, &n));
	TS_TRY(ts_expr_count(e, at, f->name, f->arguments, f->least, f->most, n));
	return ts_expr_locate_error(e, f->words(e, (struct ts_words){ word, n }, out), at, e->at);
}

enum ts_status ts_expr_call(struct ts_expr *e, const struct ts_expr_function *f, size_t at,
			    struct ts_operand *out)
{
	struct ts_operand arg[TS_MOST_ARGUMENTS] = { 0 };
	bool list = f->series || f->map;
	enum ts_formula kind = e->kind;
	enum ts_status status;
	size_t n;

	e->formulas->reads_all |= f->words || f->draw;
	if (f->words)
		return call_on_words(e, f, at, out);
	if (list)
		e->kind = TS_FORMULA_VECTOR;
	status = ts_expr_arguments(e, arg, f->most, &n);
	e->kind = kind;
	if (status != TS_OK)
		return status;
	TS_TRY(ts_expr_count(e, at, f->name, f->arguments, f->least, f->most, n));
	if (f->map && kind != TS_FORMULA_VECTOR)
		return ts_expr_fail(e, TS_SYNTAX, at, e->at, "%s gives a list; one number is needed here",
				    f->name);
	if (list)
		return call_on_list(e, f, at, arg, out);
	return f->draw ? call_random(e, f, at, arg, out) : call_elementwise(e, f, at, arg, out);
}

enum ts_status ts_expr_call_group(struct ts_expr *e, const struct ts_function *f, size_t at,
				  struct ts_operand *out)
{
	struct ts_word word[TS_MOST_ARGUMENTS] = { 0 };
	struct ts_words words = { word, 0 };
	struct ts_table table = { 0 };
	enum ts_status status;

	TS_TRY(ts_expr_words(e, at, word, TS_MOST_ARGUMENTS, &words.n));
	TS_TRY(ts_expr_count(e, at, f->name, f->arguments, f->least, f->most, words.n));
	TS_TRY(ts_expr_locate_error(e, ts_ranks_require_all(e->sim, f->name, NULL), at, e->at));
	if (f->peratom && e->kind == TS_FORMULA_PERATOM) {
		status = ts_expr_take_table(e, f->peratom(e->sim, words, &table), &table, out);
		return ts_expr_locate_error(e, ts_expr_or_unknown(e, f->name, status, out), at, e->at);
	}
	if (!f->eval)
		return ts_expr_fail(e, TS_STATE, at, e->at,
				    "%s has a value for each particle; it is allowed only in a variable of "
				    "style atom",
				    f->name);
	e->formulas->reads_all = true;
	status = ts_expr_or_unknown(e, f->name, f->eval(e->sim, words, &out->scalar), out);
	TS_TRY(ts_expr_locate_error(e, status, at, e->at));
	if (isfinite(out->scalar) || ts_unknown(e->sim, out->scalar))
		return TS_OK;
	return ts_expr_fail(e, TS_RANGE, at, e->at, "%s has no finite value", f->name);
}
