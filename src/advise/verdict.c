/* Evaluation of the trials: changes of the columns against the reference trial (the one with the smallest
 * time step), the Pareto front of cost and change, and advice. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "advise/verdict.h"
#include "explain/price.h"

#include "base/banned.h"

static const double WORTH = 0.9; /* advised below this fraction of the cost */
/* a change is significant above this multiple of that of the perturbed trial */
static const double NOISE = 3;
static const double FLOOR = 1e-12; /* relative difference that is round-off */
/* a saving is significant above this multiple of the scatter of the measured times */
static const double SURE = 2;
static const double SHORTEST = 2e-3; /* resolution of the clock (s) */
enum { COLUMNS_SHOWN = 7, LABEL_WIDTH = 30 };

/* Computing time (s) per unit of simulated time. */
static double cost_of(const struct ts_trial *t, const struct ts_trial_results *b)
{
	return t->seconds / ((double)b->steps * b->dt);
}

static const struct ts_trial *find_trial(const struct ts_trial_results *b, enum ts_subject subject)
{
	for (int k = 0; k < b->n; k++)
		if (b->trial[k].subject == (int)subject && b->trial[k].done)
			return &b->trial[k];
	return NULL;
}

/* The trial with the present settings and the perturbed one do the same work: the shorter of their times. */
static double present_seconds(const struct ts_trial_results *b)
{
	const struct ts_trial *present = find_trial(b, TS_SUBJECT_PRESENT);
	const struct ts_trial *perturbed = find_trial(b, TS_SUBJECT_PERTURBED);

	return present && perturbed ? fmin(present->seconds, perturbed->seconds)
	       : present	    ? present->seconds
				    : 0;
}

/* Relative scatter of the repetitions. */
static double spread_of(const struct ts_trial *t)
{
	return t && t->done ? (t->longest - t->seconds) / t->seconds : 0;
}

/* Relative scatter of the times of equal work: repetitions, and the present and the perturbed trial. */
static double time_noise(const struct ts_trial_results *b, const struct ts_trial *t)
{
	const struct ts_trial *present = find_trial(b, TS_SUBJECT_PRESENT);
	const struct ts_trial *perturbed = find_trial(b, TS_SUBJECT_PERTURBED);
	double noise = fmax(spread_of(t), fmax(spread_of(present), spread_of(perturbed)));

	if (present && perturbed)
		noise = fmax(noise, fabs(present->seconds - perturbed->seconds) /
					    fmin(present->seconds, perturbed->seconds));
	return fmax(noise, SHORTEST / fmax(t->seconds, 1e-9));
}

static bool is_cheaper(const struct ts_trial_results *b, const struct ts_trial *t)
{
	return t->done && t->seconds < WORTH * present_seconds(b);
}

/* Cheaper by more than the scatter of the times. */
static bool is_significantly_cheaper(const struct ts_trial_results *b, const struct ts_trial *t)
{
	return is_cheaper(b, t) && 1 - t->seconds / present_seconds(b) > SURE * time_noise(b, t);
}

/* Another contact law, but without contacts: it was not tested. */
static bool law_untested(const struct ts_trial_results *b, const struct ts_trial *t)
{
	const struct ts_trial *present = find_trial(b, TS_SUBJECT_PRESENT);

	return t->contact_law && present && !(present->contacts > 0) && !(t->contacts > 0);
}

bool ts_verdict_open(struct ts_trial_results *b, int k)
{
	const struct ts_trial *t = &b->trial[k];

	return t->subject >= TS_SUBJECT_STEP && !law_untested(b, t) && is_cheaper(b, t) &&
	       !is_significantly_cheaper(b, t);
}

/* The reference: the trial with the smallest time step and otherwise the present settings. */
static const struct ts_trial *reference_trial(const struct ts_trial_results *b)
{
	const struct ts_trial *best = find_trial(b, TS_SUBJECT_PRESENT);
	double least = b->dt;

	for (int k = 0; k < b->n; k++) {
		const struct ts_trial *t = &b->trial[k];

		if (t->subject == TS_SUBJECT_STEP && t->done && (!best || t->dt < least)) {
			best = t;
			least = t->dt;
		}
	}
	return best;
}

/* The range of a column in the trial, but at least a thousandth of its magnitude, so that round-off of a
 * constant is no change. */
static double scale_of(const struct ts_trial *t, int column)
{
	double lo = INFINITY, hi = -INFINITY;

	for (int k = 0; k <= t->samples; k++) {
		lo = fmin(lo, t->column[k][column]);
		hi = fmax(hi, t->column[k][column]);
	}
	return fmax(hi - lo, 1e-3 * fmax(fabs(lo), fabs(hi)));
}

/* The largest difference over the samples, in units of the scale. */
static double largest_change(const struct ts_trial *a, const struct ts_trial *b, int column, double scale)
{
	double most = 0;

	for (int k = 1; k <= a->samples && k <= b->samples; k++) {
		double x = a->column[k][column], y = b->column[k][column], d = fabs(x - y);

		if (isnan(x) && isnan(y))
			continue;
		if (isnan(d))
			return INFINITY;
		if (d > FLOOR * fmax(fabs(x), fabs(y)))
			most = fmax(most, d / scale);
	}
	return most;
}

/* Change of a column by round-off: that of the perturbed trial. */
static double noise_of(const struct ts_trial_results *b, int column, double scale)
{
	const struct ts_trial *present = find_trial(b, TS_SUBJECT_PRESENT);
	const struct ts_trial *perturbed = find_trial(b, TS_SUBJECT_PERTURBED);

	return present && perturbed ? largest_change(perturbed, present, column, scale) : 0;
}

/* The largest change of a trial against another one that exceeds the growth of round-off. */
static double worst_change(const struct ts_trial_results *b, const struct ts_trial *t,
			   const struct ts_trial *from, int *column)
{
	const struct ts_trial *reference = reference_trial(b);
	double worst = 0;

	*column = -1;
	for (int c = 0; c < b->columns; c++) {
		double scale = scale_of(reference, c), d = largest_change(t, from, c, scale);

		if (d > worst && !b->step_dependent[c] && d > NOISE * noise_of(b, c, scale)) {
			worst = d;
			*column = c;
		}
	}
	return worst;
}

static void compute_changes(struct ts_trial_results *b)
{
	const struct ts_trial *reference = reference_trial(b);

	for (int k = 0; k < b->n && reference; k++) {
		struct ts_trial *t = &b->trial[k];

		if (!t->done)
			continue;
		for (int c = 0; c < b->columns; c++)
			t->change[c] = largest_change(t, reference, c, scale_of(reference, c));
		t->worst = worst_change(b, t, reference, &t->worst_column);
	}
}

static void mark_front(struct ts_trial_results *b)
{
	for (int k = 0; k < b->n; k++) {
		struct ts_trial *t = &b->trial[k];

		t->pareto = t->done && t->subject != TS_SUBJECT_PERTURBED;
		for (int m = 0; m < b->n && t->pareto; m++) {
			const struct ts_trial *o = &b->trial[m];
			bool better = o->seconds < t->seconds || o->worst < t->worst;

			if (o->done && o->subject != TS_SUBJECT_PERTURBED && better &&
			    o->seconds <= t->seconds && o->worst <= t->worst)
				t->pareto = false;
		}
	}
}

/* ---- advice */

/* The cheapest time step within the tolerance of the reference; the reference itself has nothing to be
 * compared with. */
static void advise_step(struct ts_trial_results *b, double tolerance)
{
	const struct ts_trial *reference = reference_trial(b);
	struct ts_trial *best = NULL, *present = NULL;

	for (int k = 0; k < b->n; k++) {
		struct ts_trial *t = &b->trial[k];

		if (!t->done || (t->subject != TS_SUBJECT_STEP && t->subject != TS_SUBJECT_PRESENT))
			continue;
		if (t->subject == TS_SUBJECT_PRESENT)
			present = t;
		if (t != reference && t->worst <= tolerance && (!best || t->seconds < best->seconds))
			best = t;
	}
	if (!best || !present || best == present)
		return;
	best->advised = present->worst > tolerance || is_significantly_cheaper(b, best);
	best->undecided = !best->advised && is_cheaper(b, best);
}

static bool same_setting(const struct ts_trial *a, const struct ts_trial *b)
{
	return a->subject == b->subject && a->choice == b->choice;
}

/* Other settings are compared with the present settings at the same time step. */
static void advise_others(struct ts_trial_results *b, double tolerance)
{
	const struct ts_trial *present = find_trial(b, TS_SUBJECT_PRESENT);

	for (int k = 0; k < b->n && present; k++) {
		struct ts_trial *t = &b->trial[k];
		int column;

		if (!t->done || t->subject < TS_SUBJECT_SKIN || t->subject >= TS_SUBJECT_TOGETHER)
			continue;
		t->no_contacts = law_untested(b, t);
		t->undecided = !t->no_contacts && is_cheaper(b, t) && !is_significantly_cheaper(b, t) &&
			       worst_change(b, t, present, &column) <= tolerance;
		t->advised = !t->no_contacts && is_significantly_cheaper(b, t) &&
			     worst_change(b, t, present, &column) <= tolerance;
		for (int m = 0; m < k && t->advised; m++) {
			struct ts_trial *o = &b->trial[m];

			if (!o->advised || !same_setting(o, t))
				continue;
			if (o->seconds <= t->seconds)
				t->advised = false;
			else
				o->advised = false;
		}
	}
}

bool ts_verdict_combine(struct ts_trial_results *b, double tolerance)
{
	struct ts_trial all = { .subject = TS_SUBJECT_TOGETHER, .label = "all advised settings" };
	int n = 0;

	compute_changes(b);
	advise_step(b, tolerance);
	advise_others(b, tolerance);
	for (int k = 0; k < b->n; k++) {
		const struct ts_trial *t = &b->trial[k];

		if (!t->advised)
			continue;
		n++;
		all.dt = t->dt > 0 ? t->dt : all.dt;
		all.skin = t->skin > 0 ? t->skin : all.skin;
		all.threads = t->threads > 0 ? t->threads : all.threads;
	}
	if (n < 2 || b->n == TS_TRIAL_MOST)
		return false;
	b->trial[b->n++] = all;
	return true;
}

/* ---- the text */

/* The columns that differ most between settings. */
static int choose_columns(const struct ts_trial_results *b, int *shown)
{
	double most[TS_TRIAL_COLUMNS] = { 0 };
	int n = 0;

	for (int k = 0; k < b->n; k++)
		for (int c = 0; c < b->columns; c++)
			most[c] = b->trial[k].done ? fmax(most[c], b->trial[k].change[c]) : most[c];
	for (int c = 0; c < b->columns; c++) {
		int before = 0;

		for (int o = 0; o < b->columns; o++)
			before += most[o] > most[c] || (most[o] == most[c] && o < c);
		if (before < COLUMNS_SHOWN)
			shown[n++] = c;
	}
	return n;
}

enum { PERCENT = 24 };

/* A percentage with two significant digits, without exponents from 10 % on. */
static const char *percent(double part, char text[PERCENT])
{
	snprintf(text, PERCENT, part >= 0.0995 && part < 1e15 ? "%.0f %%" : "%.2g %%", 100 * part);
	return text;
}

static void add_percent(struct ts_str *out, double part, bool noise)
{
	char text[PERCENT + 8], number[PERCENT];

	if (isinf(part))
		snprintf(text, sizeof text, "nan");
	else if (part < 1e-8)
		snprintf(text, sizeof text, part > 0 ? "<1e-6 %%" : "0");
	else
		snprintf(text, sizeof text, "%s%s", noise ? "~" : "", percent(part, number));
	ts_str_addf(out, " %9s", text);
}

static void add_row(const struct ts_trial_results *b, const struct ts_trial *t, const int *shown, int n,
		    struct ts_str *out)
{
	const struct ts_trial *present = find_trial(b, TS_SUBJECT_PRESENT), *reference = reference_trial(b);

	ts_str_addf(out, "%s%s %-*s", t->pareto ? "*" : " ", t->advised ? ">" : " ", LABEL_WIDTH, t->label);
	if (!t->done) {
		ts_str_addf(out, " %.76s%s\n", *t->failure ? t->failure : "not tried, time limit reached",
			    strlen(t->failure) > 76 ? " ..." : "");
		return;
	}
	ts_str_addf(out, " %9.3g", cost_of(t, b));
	if (present && present->seconds > 0)
		ts_str_addf(out, " %6.2f", t->seconds / present->seconds);
	if (t == reference)
		ts_str_addf(out, " %9s", "reference");
	for (int k = 0; k < n && t != reference; k++) {
		double noise = noise_of(b, shown[k], scale_of(reference, shown[k]));

		add_percent(out, t->change[shown[k]], t->change[shown[k]] <= NOISE * noise);
	}
	ts_str_add(out, "\n");
}

/* Whether any column changes in the present trial: those that do not say nothing about a setting. */
static bool any_column_changes(const struct ts_trial_results *b)
{
	const struct ts_trial *t = find_trial(b, TS_SUBJECT_PRESENT);

	for (int c = 0; t && c < b->columns; c++)
		for (int k = 1; k <= t->samples; k++)
			if (!(t->column[k][c] <= t->column[0][c] && t->column[k][c] >= t->column[0][c]))
				return true;
	return !t;
}

static void add_table(const struct ts_trial_results *b, struct ts_str *out)
{
	int shown[TS_TRIAL_COLUMNS], n = choose_columns(b, shown);

	ts_str_addf(out, "   %-*s %9s %6s", LABEL_WIDTH, "setting", "s/time", "cost");
	for (int k = 0; k < n; k++)
		ts_str_addf(out, " %9.9s", b->title[shown[k]]);
	ts_str_add(out, "\n");
	for (int k = 0; k < b->n; k++)
		add_row(b, &b->trial[k], shown, n, out);
	ts_str_add(out, "s/time: computing time in seconds per unit of simulated time; cost: relative to the "
			"present settings.\nOther columns: largest difference of the thermo output from the "
			"trial with the smallest time step\n(reference), relative to the range of the "
			"column. ~: within the growth of round-off errors.\n*: no other setting is both "
			"cheaper and closer to the reference (Pareto front). >: advised\n");
	for (int c = 0; c < b->columns; c++)
		if (b->step_dependent[c]) {
			ts_str_add(out, "#: value of a fix with intervals in steps; it depends on the time "
					"step and is not assessed\n");
			break;
		}
	if (*b->interval_fixes)
		ts_str_addf(out,
			    "intervals in steps, scaled to the same physical time with other time steps: "
			    "%s\n",
			    b->interval_fixes);
	if (!any_column_changes(b))
		ts_str_add(out, "No column changes in the trials, so nothing is known about the accuracy of "
				"the settings: add what matters to\nthermo_style\n");
	if (n < b->columns)
		ts_str_addf(out, "%d column%s with smaller differences not shown\n", b->columns - n,
			    b->columns - n == 1 ? "" : "s");
}

static void add_head(const struct ts_trial_results *b, struct ts_str *out)
{
	double span = (double)b->steps * b->dt;
	char text[PERCENT];

	ts_str_addf(out, "Trials start at step %" PRId64 ", time %g, %s, with %" PRId64 " particles\n",
		    b->step, b->time, b->location, b->particles);
	ts_str_addf(out, "Each trial covers a time of %g, %" PRId64 " steps of %g", span, b->steps, b->dt);
	if (b->run_steps > 0)
		ts_str_addf(out, ": %s of the run", percent((double)b->steps / (double)b->run_steps, text));
	if (isfinite(b->limit))
		ts_str_addf(out, "; stability limit of the time step %.4g", b->limit);
	ts_str_addf(out, "\nTo repeat: -advise at %" PRId64 " steps %" PRId64 "\n\n", b->step, b->steps);
}

static void add_change(const struct ts_trial_results *b, double worst, int column, struct ts_str *out)
{
	char text[PERCENT];

	if (column < 0)
		ts_str_add(out, "no difference");
	else
		ts_str_addf(out, "largest difference %s (%s)", percent(worst, text), b->title[column]);
}

static void add_duration(const struct ts_trial_results *b, const struct ts_trial *present,
			 const struct ts_trial *t, struct ts_str *out)
{
	double per_run = (double)b->steps_left / (double)b->steps;

	ts_str_add(out, "the rest of the run takes ");
	ts_price_time(per_run * t->seconds, out);
	ts_str_add(out, " instead of ");
	ts_price_time(per_run * present->seconds, out);
}

/* Settings that may be cheaper, but whose measurement is not conclusive. */
static int add_undecided(const struct ts_trial_results *b, struct ts_str *out)
{
	bool idle = false;
	int n = 0;

	for (int k = 0; k < b->n; k++) {
		const struct ts_trial *t = &b->trial[k];

		if (t->no_contacts && !idle)
			ts_str_add(out, "contact laws: not decided, no contacts in the trials; start them "
					"later (-advise at STEP)\n");
		idle |= t->no_contacts;
		if (t->undecided)
			ts_str_addf(out,
				    "%s: not decided, cost %.2f, but times of equal trials differ by %.2g "
				    "%%; increase SECONDS\n",
				    t->label, t->seconds / present_seconds(b), 100 * time_noise(b, t));
		n += t->undecided;
	}
	return n + idle;
}

static void add_advice(const struct ts_trial_results *b, double tolerance, struct ts_str *out)
{
	const struct ts_trial *present = find_trial(b, TS_SUBJECT_PRESENT), *all = NULL, *only = NULL;
	bool step_advised = false;
	char text[PERCENT];
	int n = 0;

	for (int k = 0; k < b->n && present; k++) {
		const struct ts_trial *t = &b->trial[k];
		bool step = t->subject == TS_SUBJECT_STEP;
		double worst = t->worst;
		int column = t->worst_column;

		all = t->subject == TS_SUBJECT_TOGETHER && t->done ? t : all;
		if (!t->advised)
			continue;
		if (!step)
			worst = worst_change(b, t, present, &column);
		ts_str_addf(out, "%s: cost %.2f, ", t->label, t->seconds / present->seconds);
		add_change(b, worst, column, out);
		ts_str_addf(out, "%s\n",
			    step && present->worst > tolerance
				    ? "; the present time step exceeds the tolerance"
				    : "");
		only = t;
		step_advised |= step;
		n++;
	}
	if (present && present->worst > tolerance && !step_advised)
		ts_str_addf(out,
			    "The time step is too large: %s differs by %s, and no time step tried is "
			    "within %g %% of the reference. Try smaller ones.\n",
			    b->title[present->worst_column], percent(present->worst, text), 100 * tolerance);
	else if (!add_undecided(b, out) && !n)
		ts_str_add(out, "No better setting was found.\n");
	only = all ? all : n == 1 ? only : NULL;
	if (!only)
		return;
	ts_str_add(out, all ? "With all advised settings: " : "With this setting: ");
	add_duration(b, present, only, out);
	ts_str_add(out, "; compared with the reference: ");
	add_change(b, only->worst, only->worst_column, out);
	ts_str_add(out, "\n");
}

void ts_verdict_print(struct ts_trial_results *b, double tolerance, struct ts_str *out)
{
	compute_changes(b);
	mark_front(b);
	add_head(b, out);
	add_table(b, out);
	ts_str_add(out, "\n");
	add_advice(b, tolerance, out);
}
