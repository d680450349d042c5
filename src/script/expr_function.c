#include <math.h>
#include <string.h>

#include "script/expr.h"

#include "base/banned.h"

static const double two_pi = 2 * 3.14159265358979323846;

static enum ts_status eval_atan2(struct ts_expr *e, const double *arg, double *out)
{
	(void)e;
	*out = atan2(arg[0], arg[1]);
	return TS_OK;
}

/* Random numbers come from one stream per seed, which lives as long as the script. */
static enum ts_status stream_of(struct ts_expr *e, double seed, struct ts_rng **out)
{
	struct ts_script *s = e->script;
	size_t k = 0;

	if (!(seed >= 1 && seed < 9e15) || floor(seed) < seed)
		return ts_fail(&e->sim->error, TS_RANGE, NULL,
			       "the seed must be a positive whole number, found %.15g", seed);
	while (k < s->nstreams && s->stream[k].seed != (int64_t)seed)
		k++;
	if (k == s->nstreams) {
		if (TS_GROW(s->stream, s->stream_capacity, k + 1) != TS_OK)
			return ts_nomem(&e->sim->error);
		s->stream[k].seed = (int64_t)seed;
		s->stream[k].rng = ts_rng_start((uint64_t)seed, 0);
		s->nstreams++;
	}
	*out = &s->stream[k].rng;
	return TS_OK;
}

static enum ts_status eval_random(struct ts_expr *e, const double *arg, double *out)
{
	struct ts_rng *rng = NULL;

	TS_TRY(stream_of(e, arg[2], &rng));
	*out = arg[0] + ts_rng_uniform(rng) * (arg[1] - arg[0]);
	return TS_OK;
}

static enum ts_status eval_normal(struct ts_expr *e, const double *arg, double *out)
{
	struct ts_rng *rng = NULL;

	if (arg[1] < 0)
		return ts_fail(&e->sim->error, TS_RANGE, NULL,
			       "the standard deviation must not be negative, found %.6g", arg[1]);
	TS_TRY(stream_of(e, arg[2], &rng));
	*out = arg[0] + arg[1] * ts_rng_normal(rng);
	return TS_OK;
}

/* Time since the start of the run. */
static double elapsed(const struct ts_expr *e)
{
	return (double)(e->sim->clock.step - e->sim->clock.first_step) * e->sim->clock.dt;
}

static enum ts_status eval_ramp(struct ts_expr *e, const double *arg, double *out)
{
	double steps = (double)(e->sim->clock.last_step - e->sim->clock.first_step);
	double done = (double)(e->sim->clock.step - e->sim->clock.first_step);

	if (!e->sim->running)
		return ts_fail(&e->sim->error, TS_STATE, NULL, "ramp() has a value only in a run");
	*out = arg[0] + (arg[1] - arg[0]) * (steps > 0 ? done / steps : 0);
	return TS_OK;
}

static enum ts_status eval_vdisplace(struct ts_expr *e, const double *arg, double *out)
{
	*out = arg[0] + arg[1] * elapsed(e);
	return TS_OK;
}

static enum ts_status periodic(struct ts_expr *e, const double *arg, double *phase)
{
	if (!(arg[2] > 0))
		return ts_fail(&e->sim->error, TS_RANGE, NULL,
			       "the period must be positive, found %.6g", arg[2]);
	*phase = two_pi * elapsed(e) / arg[2];
	return TS_OK;
}

static enum ts_status eval_swiggle(struct ts_expr *e, const double *arg, double *out)
{
	double phase = 0;

	TS_TRY(periodic(e, arg, &phase));
	*out = arg[0] + arg[1] * sin(phase);
	return TS_OK;
}

static enum ts_status eval_cwiggle(struct ts_expr *e, const double *arg, double *out)
{
	double phase = 0;

	TS_TRY(periodic(e, arg, &phase));
	*out = arg[0] + arg[1] * (1 - cos(phase));
	return TS_OK;
}

/* The next after the present step of y, x, x+y, 2x, 2x+y ... */
static enum ts_status eval_stagger(struct ts_expr *e, const double *arg, double *out)
{
	double step = (double)e->sim->clock.step, start;

	if (!(arg[0] > arg[1] && arg[1] > 0))
		return ts_fail(&e->sim->error, TS_RANGE, NULL,
			       "stagger(x,y) needs x > y > 0, found %.6g and %.6g", arg[0], arg[1]);
	start = floor(step / arg[0]) * arg[0];
	*out = step < start + arg[1] ? start + arg[1] : start + arg[0];
	return TS_OK;
}

/* x, 2x .. yx, then z times as much: the next of these after the present step. */
static enum ts_status eval_logfreq(struct ts_expr *e, const double *arg, double *out)
{
	double step = (double)e->sim->clock.step, decade = arg[0], multiple;

	if (!(arg[0] > 0 && arg[1] > 0 && arg[1] < arg[2]))
		return ts_fail(&e->sim->error, TS_RANGE, NULL,
			       "logfreq(x,y,z) needs x > 0 and 0 < y < z, found %.6g, %.6g, %.6g",
			       arg[0], arg[1], arg[2]);
	while (step >= decade * arg[2])
		decade *= arg[2];
	multiple = floor(step / decade);
	*out = multiple < arg[1] ? (multiple + 1) * decade : decade * arg[2];
	return TS_OK;
}

static const struct ts_math_function functions[] = {
	{ "sqrt", "x", 1, sqrt, NULL },
	{ "exp", "x", 1, exp, NULL },
	{ "ln", "x", 1, log, NULL },
	{ "log", "x", 1, log10, NULL },
	{ "abs", "x", 1, fabs, NULL },
	{ "sin", "x", 1, sin, NULL },
	{ "cos", "x", 1, cos, NULL },
	{ "tan", "x", 1, tan, NULL },
	{ "asin", "x", 1, asin, NULL },
	{ "acos", "x", 1, acos, NULL },
	{ "atan", "x", 1, atan, NULL },
	{ "ceil", "x", 1, ceil, NULL },
	{ "floor", "x", 1, floor, NULL },
	{ "round", "x", 1, round, NULL },
	{ "atan2", "y,x", 2, NULL, eval_atan2 },
	{ "random", "lo,hi,seed", 3, NULL, eval_random },
	{ "normal", "mean,sigma,seed", 3, NULL, eval_normal },
	{ "ramp", "first,last", 2, NULL, eval_ramp },
	{ "vdisplace", "value,velocity", 2, NULL, eval_vdisplace },
	{ "swiggle", "value,amplitude,period", 3, NULL, eval_swiggle },
	{ "cwiggle", "value,amplitude,period", 3, NULL, eval_cwiggle },
	{ "stagger", "x,y", 2, NULL, eval_stagger },
	{ "logfreq", "x,y,z", 3, NULL, eval_logfreq },
};
enum { NFUNCTIONS = sizeof functions / sizeof *functions, MOST = 3 };

const struct ts_math_function *ts_math_function_find(const char *name)
{
	for (size_t k = 0; k < NFUNCTIONS; k++)
		if (ts_streq(functions[k].name, name))
			return &functions[k];
	return NULL;
}

void ts_math_function_suggest(struct ts_suggest *suggest)
{
	for (size_t k = 0; k < NFUNCTIONS; k++)
		ts_suggest_try(suggest, functions[k].name);
}

static enum ts_status evaluate(struct ts_expr *e, const struct ts_math_function *f, size_t at,
			       const double *arg, double *out)
{
	if (f->pure)
		*out = f->pure(arg[0]);
	else
		TS_TRY(ts_expr_blame(e, f->eval(e, arg, out), at, e->at));
	if (isfinite(*out))
		return TS_OK;
	return ts_expr_fail(e, TS_RANGE, at, e->at, "%s is %s, for %s = %.6g", f->name,
			    isnan(*out) ? "not a real number" : "infinite", f->arguments, arg[0]);
}

static enum ts_status wrong_count(struct ts_expr *e, const struct ts_math_function *f, size_t at,
				  size_t n)
{
	return ts_expr_fail(e, TS_SYNTAX, at, e->at + (e->text[e->at] != '\0'),
			    "%s(%s) takes %zu argument%s, found %s%zu", f->name, f->arguments, f->n,
			    f->n == 1 ? "" : "s", n > f->n ? "at least " : "", n);
}

/* Between the brackets; e->at ends behind the closing one. */
static enum ts_status read_arguments(struct ts_expr *e, const struct ts_math_function *f, size_t at,
				     struct ts_operand *arg)
{
	size_t n = 0;

	e->at++;
	if (ts_expr_peek(e) == ')')
		return wrong_count(e, f, at, 0);
	for (;;) {
		TS_TRY(ts_expr_read(e, 1, &arg[n]));
		TS_TRY(ts_op_need_number(e, &arg[n++]));
		if (ts_expr_peek(e) != ',')
			break;
		if (n == f->n)
			return wrong_count(e, f, at, n + 1);
		e->at++;
	}
	if (n != f->n)
		return wrong_count(e, f, at, n);
	return ts_expr_expect(e, ')');
}

enum ts_status ts_math_function_call(struct ts_expr *e, const struct ts_math_function *f, size_t at,
				     struct ts_operand *out)
{
	bool drawn = f->eval == eval_random || f->eval == eval_normal;
	bool many = e->peratom && drawn; /* each particle draws its own */
	struct ts_operand arg[MOST] = { 0 };
	double number[MOST] = { 0 };

	TS_TRY(read_arguments(e, f, at, arg));
	for (size_t k = 0; k < f->n; k++) {
		number[k] = arg[k].scalar;
		many |= arg[k].data != NULL;
	}
	if (!many)
		return evaluate(e, f, at, number, &out->scalar);
	out->data = ts_expr_array(e);
	if (!out->data)
		return TS_NOMEM;
	for (size_t i = 0; i < e->rows; i++) {
		for (size_t k = 0; k < f->n; k++)
			number[k] = arg[k].data ? arg[k].data[i] : arg[k].scalar;
		TS_TRY(evaluate(e, f, at, number, &out->data[i]));
	}
	return TS_OK;
}
