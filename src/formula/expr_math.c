/* Functions of numbers in formulas. */
#include <math.h>

#include "formula/expr.h"

#include "base/banned.h"

static double sign_of(double x)
{
	return x < 0 ? -1 : 1;
}

/* Halves are rounded up, also negative ones (LIGGGHTS, LAMMPS). */
static double round_half_up(double x)
{
	double below = floor(x);

	return x - below >= 0.5 ? below + 1 : below;
}

static enum ts_status eval_atan2(struct ts_expr *e, const double *arg, double *out)
{
	(void)e;
	*out = atan2(arg[0], arg[1]);
	return TS_OK;
}

static enum ts_status eval_ternary(struct ts_expr *e, const double *arg, double *out)
{
	(void)e;
	*out = arg[0] < 0 || arg[0] > 0 ? arg[1] : arg[2];
	return TS_OK;
}

static enum ts_status draw_uniform(struct ts_expr *e, const double *arg, struct ts_rng *rng, double *out)
{
	(void)e;
	*out = arg[0] + ts_rng_uniform(rng) * (arg[1] - arg[0]);
	return TS_OK;
}

static enum ts_status draw_normal(struct ts_expr *e, const double *arg, struct ts_rng *rng, double *out)
{
	if (arg[1] < 0)
		return ts_fail(&e->sim->error, TS_RANGE, NULL,
			       "the standard deviation must not be negative, found %.6g", arg[1]);
	*out = arg[0] + arg[1] * ts_rng_normal(rng);
	return TS_OK;
}

#define ONE(name_, f, help_)                                                                           \
	{                                                                                              \
		.name = (name_), .arguments = "x", .help = (help_), .least = 1, .most = 1, .pure = (f) \
	}

const struct ts_expr_function ts_math_functions[] = {
	ONE("sqrt", sqrt, "square root"),
	ONE("exp", exp, "exponential function"),
	ONE("ln", log, "natural logarithm"),
	ONE("log", log10, "logarithm of base 10"),
	ONE("abs", fabs, "absolute value"),
	ONE("sign", sign_of, "1 for x >= 0, -1 for x < 0"),
	ONE("sin", sin, "sine of an angle in radians"),
	ONE("cos", cos, "cosine"),
	ONE("tan", tan, "tangent"),
	ONE("asin", asin, "arc sine"),
	ONE("acos", acos, "arc cosine"),
	ONE("atan", atan, "arc tangent"),
	{ .name = "atan2",
	  .arguments = "y,x",
	  .help = "angle of the point x,y, from -PI to PI",
	  .least = 2,
	  .most = 2,
	  .eval = eval_atan2 },
	ONE("ceil", ceil, "smallest whole number not below x"),
	ONE("floor", floor, "largest whole number not above x"),
	ONE("round", round_half_up, "nearest whole number, halves up: round(-2.5) is -2"),
	{ .name = "ternary",
	  .arguments = "x,y,z",
	  .help = "y if x is not 0, else z",
	  .least = 3,
	  .most = 3,
	  .eval = eval_ternary,
	  .lazy = true },
	{ .name = "random",
	  .arguments = "lo,hi,seed",
	  .help = "random number, uniform between lo and hi",
	  .least = 3,
	  .most = 3,
	  .draw = draw_uniform },
	{ .name = "normal",
	  .arguments = "mean,sigma,seed",
	  .help = "random number, normally distributed",
	  .least = 3,
	  .most = 3,
	  .draw = draw_normal },
	{ .name = NULL },
};
