#include "plot/plot_scale.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/banned.h"

enum { MOST_DIGITS = 6 };
/* A range narrower than this part of its distance from zero is rounding. */
static const double CONSTANT = 1e-13;
/* Share of the range that is left free at both ends; zero is drawn if it is nearer than the second one. */
static const double FREE = 0.05, NEAR_ZERO = 0.3;
/* An end that is so near to a tick outside of it is moved there, as a part of the range. */
static const double NEAR_TICK = 0.03;

/* ---- ranges */

static const struct ts_plot_axis *axis_of(const struct ts_plot *plot, int axis)
{
	return axis == 0 ? &plot->x : axis == 1 ? &plot->y : &plot->right;
}

/* The end that is given, or NaN. */
static double given(const struct ts_plot_axis *axis, bool upper)
{
	const double end = upper ? axis->hi : axis->lo;

	return axis->lo == axis->hi || !ts_plot_shows(axis, end) ? NAN : end;
}

/* Not beyond an end that is given; true with those that are NaN. */
static bool is_inside(const struct ts_plot_axis *axis, double value)
{
	return !(value < given(axis, false)) && !(value > given(axis, true));
}

static void include(struct ts_plot_extent *e, const struct ts_plot *plot, int axis, double value)
{
	if (!ts_plot_shows(axis_of(plot, axis), value))
		return;
	e->lo[axis] = fmin(e->lo[axis], value);
	e->hi[axis] = fmax(e->hi[axis], value);
}

static void include_point(struct ts_plot_extent *e, const struct ts_plot *plot,
			  const struct ts_plot_series *s, size_t k)
{
	const double x = ts_plot_x(s, k), y = s->y[k], error = s->error ? s->error[k] : 0,
		     x_error = s->x_error ? s->x_error[k] : 0;
	const int axis = s->right ? 2 : 1;

	e->points++;
	if (!ts_plot_shows(&plot->x, x) || !ts_plot_shows(axis_of(plot, axis), y)) {
		e->hidden++;
		return;
	}
	if (is_inside(axis_of(plot, axis), y)) {
		include(e, plot, 0, x);
		include(e, plot, 0, x - x_error);
		include(e, plot, 0, x + x_error);
	}
	if (!is_inside(&plot->x, x))
		return;
	include(e, plot, axis, y);
	include(e, plot, axis, y - error);
	include(e, plot, axis, y + error);
}

/* The first and the last step reach beyond their points. */
static void include_steps(struct ts_plot_extent *e, const struct ts_plot *plot,
			  const struct ts_plot_series *s)
{
	const size_t n = s->n;

	if (s->style != TS_PLOT_STEPS || n < 2)
		return;
	include(e, plot, 0, 1.5 * ts_plot_x(s, 0) - 0.5 * ts_plot_x(s, 1));
	include(e, plot, 0, 1.5 * ts_plot_x(s, n - 1) - 0.5 * ts_plot_x(s, n - 2));
}

void ts_plot_extent(const struct ts_plot *plot, struct ts_plot_extent *e)
{
	*e = (struct ts_plot_extent){ .lo = { INFINITY, INFINITY, INFINITY },
				      .hi = { -INFINITY, -INFINITY, -INFINITY } };
	for (size_t k = 0; k < plot->n; k++) {
		for (size_t j = 0; j < plot->series[k].n; j++)
			include_point(e, plot, &plot->series[k], j);
		include_steps(e, plot, &plot->series[k]);
	}
	for (size_t k = 0; k < plot->marks; k++)
		include(e, plot, !plot->mark[k].vertical, plot->mark[k].at);
}

static bool has_bare_lines(const struct ts_plot *plot)
{
	for (size_t k = 0; k < plot->n; k++)
		if (ts_plot_has_points(&plot->series[k]))
			return false;
	return true;
}

/* Ends from the data: some room, zero if it is near. */
static void set_linear_ends(double *lo, double *hi, bool room)
{
	const double low = *lo, high = *hi, range = high - low;

	if (range <= CONSTANT * fmax(fabs(low), fabs(high)) || range < DBL_MIN / CONSTANT) {
		const double half = low == 0 ? 1 : fmax(0.1 * fabs(low), DBL_MIN / CONSTANT);

		*lo = low - half;
		*hi = low + half;
	} else if (room) {
		*lo = low >= 0 && low < NEAR_ZERO * high ? 0 : low - FREE * range;
		*hi = high <= 0 && high > NEAR_ZERO * low ? 0 : high + FREE * range;
	}
}

/* Decimal logarithms of the ends. */
static void set_log_ends(double *lo, double *hi, bool room)
{
	double range;

	*lo = log10(*lo);
	*hi = log10(*hi);
	range = *hi - *lo;
	if (range < 1e-6) {
		*lo -= 0.5;
		*hi += 0.5;
	} else if (room) {
		*lo -= FREE * range;
		*hi += FREE * range;
	}
}

static void set_ends(struct ts_plot_scale *scale, const struct ts_plot *plot,
		     const struct ts_plot_extent *extent, int axis)
{
	const struct ts_plot_axis *a = axis_of(plot, axis);
	const double lo = given(a, false), hi = given(a, true);
	const bool room = axis > 0 || !has_bare_lines(plot);

	scale->lo = extent->lo[axis];
	scale->hi = extent->hi[axis];
	if (!(scale->lo <= scale->hi)) { /* no data */
		scale->lo = a->log ? 1 : 0;
		scale->hi = a->log ? 10 : 1;
	}
	if (!isnan(lo))
		scale->lo = lo, scale->hi = fmax(lo, scale->hi);
	if (!isnan(hi))
		scale->hi = hi, scale->lo = fmin(hi, scale->lo);
	if (a->log)
		set_log_ends(&scale->lo, &scale->hi, room);
	else
		set_linear_ends(&scale->lo, &scale->hi, room);
	if (!isnan(lo))
		scale->lo = a->log ? log10(lo) : lo;
	if (!isnan(hi))
		scale->hi = a->log ? log10(hi) : hi;
}

/* ---- ticks */

static double power_of_ten(int exponent)
{
	return pow(10, exponent);
}

/* The distance of about so many ticks: 1, 2 or 5 times a power of ten. */
static double round_step(double range, int ticks)
{
	const double number = 0.8 * range / ticks;
	const double power = power_of_ten((int)floor(log10(number))), part = number / power;

	return power * (part <= 1 ? 1 : part <= 2 ? 2 : part <= 5 ? 5 : 10);
}

static void add_tick(struct ts_plot_scale *scale, double at, const char *text)
{
	struct ts_plot_tick *tick = &scale->tick[scale->n];

	if (scale->n == TS_PLOT_TICKS || !(at >= -1e-9 && at <= 1 + 1e-9))
		return;
	*tick = (struct ts_plot_tick){ .at = fmin(fmax(at, 0), 1) };
	snprintf(tick->text, sizeof tick->text, "%.*s", (int)sizeof tick->text - 1, text);
	scale->n++;
}

/* Decimals that tell multiples of a step apart. */
static int decimals_of(double step)
{
	const int digits = -(int)floor(log10(step) + 1e-9);

	return digits > 0 ? digits : 0;
}

/* What is taken off the numbers, and their common power of ten. */
static void set_label_form(struct ts_plot_scale *scale, double step)
{
	const double most = fmax(fabs(scale->lo), fabs(scale->hi));
	double largest = most;

	if (log10(most / step) > MOST_DIGITS) {
		const double round = power_of_ten((int)ceil(log10(scale->hi - scale->lo) - 0.1));

		scale->offset = floor(scale->lo / round) * round;
		scale->offset_digits = 1 + (int)ceil(log10(most / round));
		largest = scale->hi - scale->offset;
	}
	if (largest >= 1e5 || largest < 0.99e-2)
		scale->exponent = 3 * (int)floor(log10(largest) / 3 + 1e-9);
}

/* Moves ends that are not given to ticks near them. */
static void snap_ends(struct ts_plot_scale *scale, const struct ts_plot_axis *a, int ticks)
{
	const double range = scale->hi - scale->lo, step = round_step(range, ticks);
	const double lo = floor(scale->lo / step) * step, hi = ceil(scale->hi / step) * step;

	if (isnan(given(a, false)) && scale->lo - lo < NEAR_TICK * range)
		scale->lo = lo;
	if (isnan(given(a, true)) && hi - scale->hi < NEAR_TICK * range)
		scale->hi = hi;
}

static void set_linear_ticks(struct ts_plot_scale *scale, int ticks)
{
	const double step = round_step(scale->hi - scale->lo, ticks);
	const double first = ceil(scale->lo / step - 1e-6), last = floor(scale->hi / step + 1e-6);
	double unit;
	int decimals;

	set_label_form(scale, step);
	unit = power_of_ten(scale->exponent);
	decimals = decimals_of(step / unit);
	for (double k = first; k <= last && scale->n < TS_PLOT_TICKS; k++) {
		char text[64];
		double value = (k * step - scale->offset) / unit;

		if (fabs(value) < 0.5 * step / unit) /* no -0 */
			value = 0;
		snprintf(text, sizeof text, "%.*f", decimals, value);
		add_tick(scale, (k * step - scale->lo) / (scale->hi - scale->lo), text);
	}
}

/* Powers of ten, every so many of them, and with `fine` 2 and 5 times these. */
static void set_log_ticks(struct ts_plot_scale *scale, int every, bool fine)
{
	static const int parts[] = { 1, 2, 5 };
	const bool plain = scale->lo > -3.7 && scale->hi < 4.7;

	scale->n = 0;
	for (int e = (int)floor(scale->lo); e <= (int)floor(scale->hi); e++)
		for (int k = 0; k < (fine ? 3 : 1); k++) {
			char text[64];

			if (e % every != 0)
				continue;
			if (plain)
				snprintf(text, sizeof text, "%.*f", e < 0 ? -e : 0,
					 parts[k] * power_of_ten(e));
			else
				snprintf(text, sizeof text, "%de%d", parts[k], e);
			add_tick(scale, (e + log10(parts[k]) - scale->lo) / (scale->hi - scale->lo), text);
		}
}

/* Lines between the powers of ten. */
static void add_minor_ticks(struct ts_plot_scale *scale)
{
	const double range = scale->hi - scale->lo;

	for (int e = (int)floor(scale->lo); e <= (int)floor(scale->hi); e++) {
		add_tick(scale, (e + log10(2) - scale->lo) / range, "");
		add_tick(scale, (e + log10(5) - scale->lo) / range, "");
	}
}

/* Less than a third of a decade: equal steps of the number itself. */
static void set_narrow_log_ticks(struct ts_plot_scale *scale, int ticks)
{
	const double lo = scale->lo, range = scale->hi - lo;
	struct ts_plot_scale linear = { .lo = pow(10, lo), .hi = pow(10, scale->hi) };

	scale->n = 0;
	set_linear_ticks(&linear, ticks);
	for (size_t k = 0; k < linear.n; k++) {
		const double value = linear.lo + linear.tick[k].at * (linear.hi - linear.lo);

		add_tick(scale, (log10(value) - lo) / range, linear.tick[k].text);
	}
	scale->offset = linear.offset;
	scale->offset_digits = linear.offset_digits;
	scale->exponent = linear.exponent;
}

void ts_plot_scale_set(struct ts_plot_scale *scale, const struct ts_plot *plot,
		       const struct ts_plot_extent *extent, int axis, int ticks)
{
	double range;
	bool fine;

	*scale = (struct ts_plot_scale){ .log = axis_of(plot, axis)->log };
	ticks = ticks < 2 ? 2 : ticks > TS_PLOT_TICKS / 2 ? TS_PLOT_TICKS / 2 : ticks;
	set_ends(scale, plot, extent, axis);
	if (!scale->log) {
		snap_ends(scale, axis_of(plot, axis), ticks);
		set_linear_ticks(scale, ticks);
		return;
	}
	range = scale->hi - scale->lo;
	fine = 2 * range <= ticks;
	set_log_ticks(scale, (int)ceil(range / (1.5 * ticks)), fine);
	if (scale->n < 3 && !fine)
		set_log_ticks(scale, 1, fine = true);
	if (scale->n < 3)
		set_narrow_log_ticks(scale, ticks);
	else if (!fine && range <= 4)
		add_minor_ticks(scale);
}

double ts_plot_scale_at(const struct ts_plot_scale *scale, double value)
{
	const double number = scale->log ? (value > 0 ? log10(value) : NAN) : value;

	return (number - scale->lo) / (scale->hi - scale->lo);
}

/* ---- texts */

void ts_plot_scale_power(int exponent, struct ts_str *out)
{
	static const char *const digit[] = { "\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
					     "\u2075", "\u2076", "\u2077", "\u2078", "\u2079" };
	char text[16];

	snprintf(text, sizeof text, "%d", exponent);
	ts_str_add(out, "10");
	for (const char *c = text; *c; c++)
		ts_str_add(out, *c == '-' ? "\u207b" : digit[*c - '0']);
}

void ts_plot_scale_pretty(const char *text, struct ts_str *out)
{
	const char *e = strchr(text, 'e');
	int64_t exponent;

	if (*text == '-')
		ts_str_add(out, "\u2212"), text++;
	if (!e || !ts_parse_int(e + 1, &exponent)) {
		ts_str_add(out, text);
		return;
	}
	if (e != text + 1 || *text != '1') {
		ts_str_add_n(out, text, (size_t)(e - text));
		ts_str_add(out, "\u00b7");
	}
	ts_plot_scale_power((int)exponent, out);
}

void ts_plot_scale_title(const struct ts_plot_scale *scale, const struct ts_plot_axis *axis,
			 struct ts_str *out)
{
	const bool unit = axis->unit && *axis->unit, power = scale->exponent != 0;

	if (axis->label)
		ts_str_add(out, axis->label);
	if (scale->offset != 0)
		ts_str_addf(out, "%s%s %.*g", axis->label ? " " : "", scale->offset < 0 ? "+" : "\u2212",
			    scale->offset_digits, fabs(scale->offset));
	if (!unit && !power)
		return;
	ts_str_add(out, out->length ? " (" : "(");
	if (power)
		ts_plot_scale_power(scale->exponent, out);
	ts_str_addf(out, "%s%s)", unit && power ? " " : "", unit ? axis->unit : "");
}
