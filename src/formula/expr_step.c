/* Functions of the step: values that vary over a run, and the next step of a sequence (for `dump_modify
 * every`, `thermo v_name` ...). */
#include <math.h>

#include "math/constants.h"
#include "formula/expr.h"

#include "base/banned.h"

static const double two_pi = 2 * TS_PI;
/* Value of a sequence that has ended: a step beyond all runs. */
static const double never = 9e18;

/* Steps since the start of the run. */
static double steps_done(const struct ts_expr *e)
{
	return (double)(e->sim->clock.step - e->sim->clock.ramp_first);
}

static enum ts_status eval_ramp(struct ts_expr *e, const double *arg, double *out)
{
	double steps = (double)(e->sim->clock.ramp_last - e->sim->clock.ramp_first);

	if (!e->sim->run.inside)
		return ts_fail(&e->sim->error, TS_STATE, NULL, "ramp() has a value only in a run");
	*out = arg[0] + (arg[1] - arg[0]) * (steps > 0 ? steps_done(e) / steps : 0);
	return TS_OK;
}

static enum ts_status eval_vdisplace(struct ts_expr *e, const double *arg, double *out)
{
	*out = arg[0] + arg[1] * steps_done(e) * e->sim->clock.dt;
	return TS_OK;
}

static enum ts_status phase_of_oscillation(struct ts_expr *e, const double *arg, double *phase)
{
	if (!(arg[2] > 0))
		return ts_fail(&e->sim->error, TS_RANGE, NULL, "the period must be positive, found %.6g",
			       arg[2]);
	*phase = two_pi / arg[2] * steps_done(e) * e->sim->clock.dt;
	return TS_OK;
}

static enum ts_status eval_swiggle(struct ts_expr *e, const double *arg, double *out)
{
	double phase = 0;

	TS_TRY(phase_of_oscillation(e, arg, &phase));
	*out = arg[0] + arg[1] * sin(phase);
	return TS_OK;
}

static enum ts_status eval_cwiggle(struct ts_expr *e, const double *arg, double *out)
{
	double phase = 0;

	TS_TRY(phase_of_oscillation(e, arg, &phase));
	*out = arg[0] + arg[1] * (1 - cos(phase));
	return TS_OK;
}

/* Steps are integers: fractions are truncated. */
static void truncate_to_steps(const double *arg, size_t n, double *out)
{
	for (size_t k = 0; k < n; k++)
		out[k] = trunc(arg[k]);
}

static enum ts_status eval_stagger(struct ts_expr *e, const double *arg, double *out)
{
	double step = (double)e->sim->clock.step, start, a[2];

	truncate_to_steps(arg, 2, a);
	if (!(a[0] > a[1] && a[1] > 0))
		return ts_fail(&e->sim->error, TS_RANGE, NULL,
			       "stagger(x,y) needs x > y > 0, found %.6g and %.6g", arg[0], arg[1]);
	start = floor(step / a[0]) * a[0];
	*out = step < start + a[1] ? start + a[1] : start + a[0];
	return TS_OK;
}

/* Checks x, y, z of the logarithmic sequences; *out: the start x z^m of the present decade. */
static enum ts_status find_decade(struct ts_expr *e, const char *name, const double *arg, double *a,
				  double *out)
{
	double step = (double)e->sim->clock.step;

	truncate_to_steps(arg, 3, a);
	if (!(a[0] > 0 && a[1] > 0 && a[2] > 1))
		return ts_fail(&e->sim->error, TS_RANGE, NULL,
			       "%s(x,y,z) needs x > 0, y > 0 and z > 1, found %.6g, %.6g, %.6g", name, arg[0],
			       arg[1], arg[2]);
	for (*out = a[0]; step >= *out * a[2];)
		*out *= a[2];
	return TS_OK;
}

/* x, 2x .. yx, then the same multiplied by z, z^2 ... */
static enum ts_status eval_logfreq(struct ts_expr *e, const double *arg, double *out)
{
	double a[3], start = 0, multiple;

	TS_TRY(find_decade(e, "logfreq", arg, a, &start));
	if (!(a[1] < a[2]))
		return ts_fail(&e->sim->error, TS_RANGE, NULL,
			       "logfreq(x,y,z) needs y < z, found %.6g and %.6g", arg[1], arg[2]);
	multiple = floor((double)e->sim->clock.step / start);
	*out = multiple < a[1] ? (multiple + 1) * start : start * a[2];
	return TS_OK;
}

/* y steps, evenly spaced, from x to zx, then from zx to zzx ... */
static enum ts_status eval_logfreq2(struct ts_expr *e, const double *arg, double *out)
{
	double step = (double)e->sim->clock.step, a[3], start = 0, width, k;

	TS_TRY(find_decade(e, "logfreq2", arg, a, &start));
	*out = a[0];
	if (step < a[0])
		return TS_OK;
	width = start * (a[2] - 1);
	k = floor((step - start) * a[1] / width);
	*out = start + ceil((k + 1) * width / a[1]);
	return TS_OK;
}

/* y steps from x to z, evenly spaced on a logarithmic scale */
static enum ts_status eval_logfreq3(struct ts_expr *e, const double *arg, double *out)
{
	double step = (double)e->sim->clock.step, a[3], ratio, k = 0;

	truncate_to_steps(arg, 3, a);
	if (!(a[0] > 0 && a[1] > 1 && a[2] > a[0] && a[2] - a[0] + 1 >= a[1]))
		return ts_fail(&e->sim->error, TS_RANGE, NULL,
			       "logfreq3(x,y,z) needs 0 < x < z and 1 < y <= z - x + 1, found %.6g, %.6g, "
			       "%.6g",
			       arg[0], arg[1], arg[2]);
	*out = a[0];
	if (step < a[0])
		return TS_OK;
	ratio = pow(a[2] / a[0], 1 / (a[1] - 1));
	while (*out <= step && k < a[1])
		*out = fmax(*out + 1, ceil(a[0] * pow(ratio, ++k) * (1 - 1e-12)));
	if (step >= a[2])
		*out = never;
	return TS_OK;
}

static double next_multiple(double step, double first, double last, double width)
{
	double next = first + (floor((step - first) / width) + 1) * width;

	return step < first ? first : next > last ? never : next;
}

static enum ts_status eval_stride(struct ts_expr *e, const double *arg, double *out)
{
	double step = (double)e->sim->clock.step, a[3];

	truncate_to_steps(arg, 3, a);
	if (!(a[0] >= 0 && a[1] >= a[0] && a[2] > 0))
		return ts_fail(&e->sim->error, TS_RANGE, NULL,
			       "stride(x,y,z) needs 0 <= x <= y and z > 0, found %.6g, %.6g, %.6g", arg[0],
			       arg[1], arg[2]);
	*out = next_multiple(step, a[0], a[1], a[2]);
	return TS_OK;
}

static enum ts_status eval_stride2(struct ts_expr *e, const double *arg, double *out)
{
	double step = (double)e->sim->clock.step, a[6];

	truncate_to_steps(arg, 6, a);
	if (!(a[0] >= 0 && a[1] >= a[0] && a[2] > 0 && a[3] >= a[0] && a[4] >= a[3] && a[4] <= a[1] &&
	      a[5] > 0))
		return ts_fail(&e->sim->error, TS_RANGE, NULL,
			       "stride2(x,y,z,a,b,c) needs 0 <= x <= a <= b <= y, z > 0 and c > 0");
	*out = never;
	if (step < a[3])
		*out = fmin(next_multiple(step, a[0], a[1], a[2]), a[3]);
	else if (step < a[4])
		*out = next_multiple(step, a[3], a[4], a[5]);
	if (*out >= never) /* behind the steps a..b */
		*out = next_multiple(fmax(step, a[4]), a[0], a[1], a[2]);
	return TS_OK;
}

const struct ts_expr_function ts_step_functions[] = {
	{ .name = "ramp",
	  .arguments = "first,last",
	  .help = "varies linearly from first to last over the run",
	  .least = 2,
	  .most = 2,
	  .eval = eval_ramp },
	{ .name = "vdisplace",
	  .arguments = "value,velocity",
	  .help = "value + velocity t, with t the time since the start of the run",
	  .least = 2,
	  .most = 2,
	  .eval = eval_vdisplace },
	{ .name = "swiggle",
	  .arguments = "value,amplitude,period",
	  .help = "value + amplitude sin(2 PI t/period)",
	  .least = 3,
	  .most = 3,
	  .eval = eval_swiggle },
	{ .name = "cwiggle",
	  .arguments = "value,amplitude,period",
	  .help = "value + amplitude (1 - cos(2 PI t/period))",
	  .least = 3,
	  .most = 3,
	  .eval = eval_cwiggle },
	{ .name = "stagger",
	  .arguments = "x,y",
	  .help = "the next of the steps y, x, x+y, 2x, 2x+y ...",
	  .least = 2,
	  .most = 2,
	  .eval = eval_stagger },
	{ .name = "logfreq",
	  .arguments = "x,y,z",
	  .help = "the next of the steps x, 2x .. yx, zx, 2zx .. yzx, zzx ...",
	  .least = 3,
	  .most = 3,
	  .eval = eval_logfreq },
	{ .name = "logfreq2",
	  .arguments = "x,y,z",
	  .help = "the next of y evenly spaced steps from x to zx, y from zx to zzx ...",
	  .least = 3,
	  .most = 3,
	  .eval = eval_logfreq2 },
	{ .name = "logfreq3",
	  .arguments = "x,y,z",
	  .help = "the next of y steps from x to z, evenly spaced on a logarithmic scale",
	  .least = 3,
	  .most = 3,
	  .eval = eval_logfreq3 },
	{ .name = "stride",
	  .arguments = "x,y,z",
	  .help = "the next of the steps x, x+z, x+2z .. y",
	  .least = 3,
	  .most = 3,
	  .eval = eval_stride },
	{ .name = "stride2",
	  .arguments = "x,y,z,a,b,c",
	  .help = "as stride, but every c steps from a to b",
	  .least = 6,
	  .most = 6,
	  .eval = eval_stride2 },
	{ .name = NULL },
};
