/* What the trials mean: changes of the columns, the settings of which none is both cheaper and closer to the
 * finest, and advice. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "advise/verdict.h"
#include "explain/price.h"

#include "base/banned.h"

static const double WORTH = 0.9;   /* advised from this part of the cost on */
static const double NOISE = 3;	   /* a change counts if it is so many times that of the twin */
static const double FLOOR = 1e-12; /* a difference of round-off, in parts of the magnitude */
/* a saving counts if it is so many times what times of the same differ by */
static const double SURE = 2;
static const double SHORTEST = 2e-3; /* seconds: less is the clock's own */
enum { COLUMNS_SHOWN = 7, LABEL_WIDTH = 30 };

static double cost_of(const struct ts_trial *t, const struct ts_board *b)
{
	return t->seconds / ((double)b->steps * b->dt);
}

static const struct ts_trial *first_of(const struct ts_board *b, enum ts_subject subject)
{
	for (int k = 0; k < b->n; k++)
		if (b->trial[k].subject == (int)subject && b->trial[k].done)
			return &b->trial[k];
	return NULL;
}

/* The scene as it is and its twin do the same work: the least of their times. */
static double present_seconds(const struct ts_board *b)
{
	const struct ts_trial *here = first_of(b, TS_SUBJECT_PRESENT);
	const struct ts_trial *twin = first_of(b, TS_SUBJECT_TWIN);

	return here && twin ? fmin(here->seconds, twin->seconds) : here ? here->seconds : 0;
}

static double spread_of(const struct ts_trial *t)
{
	return t && t->done ? (t->longest - t->seconds) / t->seconds : 0;
}

/* How much times of the same differ, in parts of them: the scene and its twin do the same work, and so do
 * repeats. */
static double time_noise(const struct ts_board *b, const struct ts_trial *t)
{
	const struct ts_trial *here = first_of(b, TS_SUBJECT_PRESENT);
	const struct ts_trial *twin = first_of(b, TS_SUBJECT_TWIN);
	double noise = fmax(spread_of(t), fmax(spread_of(here), spread_of(twin)));

	if (here && twin)
		noise = fmax(noise, fabs(here->seconds - twin->seconds) / fmin(here->seconds, twin->seconds));
	return fmax(noise, SHORTEST / fmax(t->seconds, 1e-9));
}

static bool seems_worth(const struct ts_board *b, const struct ts_trial *t)
{
	return t->done && t->seconds < WORTH * present_seconds(b);
}

/* Cheaper by more than times differ anyway. */
static bool surely_worth(const struct ts_board *b, const struct ts_trial *t)
{
	return seems_worth(b, t) && 1 - t->seconds / present_seconds(b) > SURE * time_noise(b, t);
}

/* Nothing touched, so a law of contacts has not been tried. */
static bool law_of_nothing(const struct ts_board *b, const struct ts_trial *t)
{
	const struct ts_trial *here = first_of(b, TS_SUBJECT_PRESENT);

	return t->law && here && !(here->contacts > 0) && !(t->contacts > 0);
}

bool ts_verdict_open(struct ts_board *b, int k)
{
	const struct ts_trial *t = &b->trial[k];

	return t->subject >= TS_SUBJECT_STEP && !law_of_nothing(b, t) && seems_worth(b, t) &&
	       !surely_worth(b, t);
}

/* The trial with the smallest step, all else as the scene has it. */
static const struct ts_trial *finest(const struct ts_board *b)
{
	const struct ts_trial *best = first_of(b, TS_SUBJECT_PRESENT);
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

/* What a column goes through, but at least a thousandth of its magnitude: round-off of a constant is no
 * change. */
static double scale_of(const struct ts_trial *t, int column)
{
	double lo = INFINITY, hi = -INFINITY;

	for (int k = 0; k <= t->looks; k++) {
		lo = fmin(lo, t->column[k][column]);
		hi = fmax(hi, t->column[k][column]);
	}
	return fmax(hi - lo, 1e-3 * fmax(fabs(lo), fabs(hi)));
}

/* The largest difference at any look, in units of the scale. */
static double change(const struct ts_trial *a, const struct ts_trial *b, int column, double scale)
{
	double most = 0;

	for (int k = 1; k <= a->looks && k <= b->looks; k++) {
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

static double noise_of(const struct ts_board *b, int column, double scale)
{
	const struct ts_trial *here = first_of(b, TS_SUBJECT_PRESENT);
	const struct ts_trial *twin = first_of(b, TS_SUBJECT_TWIN);

	return here && twin ? change(twin, here, column, scale) : 0;
}

/* The largest change of a trial from another that is more than round-off grown large. */
static double worst_change(const struct ts_board *b, const struct ts_trial *t, const struct ts_trial *from,
			   int *column)
{
	const struct ts_trial *finer = finest(b);
	double worst = 0;

	*column = -1;
	for (int c = 0; c < b->columns; c++) {
		double scale = scale_of(finer, c), d = change(t, from, c, scale);

		if (d > worst && !b->counts[c] && d > NOISE * noise_of(b, c, scale)) {
			worst = d;
			*column = c;
		}
	}
	return worst;
}

static void measure(struct ts_board *b)
{
	const struct ts_trial *finer = finest(b);

	for (int k = 0; k < b->n && finer; k++) {
		struct ts_trial *t = &b->trial[k];

		if (!t->done)
			continue;
		for (int c = 0; c < b->columns; c++)
			t->change[c] = change(t, finer, c, scale_of(finer, c));
		t->worst = worst_change(b, t, finer, &t->worst_column);
	}
}

static void mark_front(struct ts_board *b)
{
	for (int k = 0; k < b->n; k++) {
		struct ts_trial *t = &b->trial[k];

		t->front = t->done && t->subject != TS_SUBJECT_TWIN;
		for (int m = 0; m < b->n && t->front; m++) {
			const struct ts_trial *o = &b->trial[m];
			bool better = o->seconds < t->seconds || o->worst < t->worst;

			if (o->done && o->subject != TS_SUBJECT_TWIN && better && o->seconds <= t->seconds &&
			    o->worst <= t->worst)
				t->front = false;
		}
	}
}

/* ---- advice */

/* The cheapest step that is close enough to the finest, which is no proof of itself. */
static void advise_step(struct ts_board *b, double tolerance)
{
	const struct ts_trial *finer = finest(b);
	struct ts_trial *best = NULL, *here = NULL;

	for (int k = 0; k < b->n; k++) {
		struct ts_trial *t = &b->trial[k];

		if (!t->done || (t->subject != TS_SUBJECT_STEP && t->subject != TS_SUBJECT_PRESENT))
			continue;
		if (t->subject == TS_SUBJECT_PRESENT)
			here = t;
		if (t != finer && t->worst <= tolerance && (!best || t->seconds < best->seconds))
			best = t;
	}
	if (!best || !here || best == here)
		return;
	best->advised = here->worst > tolerance || surely_worth(b, best);
	best->undecided = !best->advised && seems_worth(b, best);
}

static bool same_thing(const struct ts_trial *a, const struct ts_trial *b)
{
	return a->subject == b->subject && a->choice == b->choice;
}

/* All else is compared with the scene as it is, at its step. */
static void advise_others(struct ts_board *b, double tolerance)
{
	const struct ts_trial *here = first_of(b, TS_SUBJECT_PRESENT);

	for (int k = 0; k < b->n && here; k++) {
		struct ts_trial *t = &b->trial[k];
		int column;

		if (!t->done || t->subject < TS_SUBJECT_SKIN || t->subject >= TS_SUBJECT_TOGETHER)
			continue;
		t->idle = law_of_nothing(b, t);
		t->undecided = !t->idle && seems_worth(b, t) && !surely_worth(b, t) &&
			       worst_change(b, t, here, &column) <= tolerance;
		t->advised = !t->idle && surely_worth(b, t) && worst_change(b, t, here, &column) <= tolerance;
		for (int m = 0; m < k && t->advised; m++) {
			struct ts_trial *o = &b->trial[m];

			if (!o->advised || !same_thing(o, t))
				continue;
			if (o->seconds <= t->seconds)
				t->advised = false;
			else
				o->advised = false;
		}
	}
}

bool ts_verdict_combine(struct ts_board *b, double tolerance)
{
	struct ts_trial all = { .subject = TS_SUBJECT_TOGETHER, .label = "all that is advised" };
	int n = 0;

	measure(b);
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
static int choose_columns(const struct ts_board *b, int *shown)
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

static void add_percent(struct ts_str *out, double part, bool noise)
{
	char text[32];

	if (isinf(part))
		snprintf(text, sizeof text, "lost");
	else if (part < 1e-8)
		snprintf(text, sizeof text, part > 0 ? "<1e-6 %%" : "0");
	else
		snprintf(text, sizeof text, "%s%.2g %%", noise ? "~" : "", 100 * part);
	ts_str_addf(out, " %9s", text);
}

static void add_row(const struct ts_board *b, const struct ts_trial *t, const int *shown, int n,
		    struct ts_str *out)
{
	const struct ts_trial *here = first_of(b, TS_SUBJECT_PRESENT), *finer = finest(b);

	ts_str_addf(out, "%s%s %-*s", t->front ? "*" : " ", t->advised ? ">" : " ", LABEL_WIDTH, t->label);
	if (!t->done) {
		ts_str_addf(out, " %.76s%s\n", *t->trouble ? t->trouble : "not tried, no time was left",
			    strlen(t->trouble) > 76 ? " ..." : "");
		return;
	}
	ts_str_addf(out, " %9.3g", cost_of(t, b));
	if (here && here->seconds > 0)
		ts_str_addf(out, " %6.2f", t->seconds / here->seconds);
	if (t == finer)
		ts_str_addf(out, " %9s", "finest");
	for (int k = 0; k < n && t != finer; k++) {
		double noise = noise_of(b, shown[k], scale_of(finer, shown[k]));

		add_percent(out, t->change[shown[k]], t->change[shown[k]] <= NOISE * noise);
	}
	ts_str_add(out, "\n");
}

static void add_table(const struct ts_board *b, struct ts_str *out)
{
	int shown[TS_TRIAL_COLUMNS], n = choose_columns(b, shown);

	ts_str_addf(out, "   %-*s %9s %6s", LABEL_WIDTH, "setting", "s/time", "cost");
	for (int k = 0; k < n; k++)
		ts_str_addf(out, " %9.9s", b->title[shown[k]]);
	ts_str_add(out, "\n");
	for (int k = 0; k < b->n; k++)
		add_row(b, &b->trial[k], shown, n, out);
	ts_str_add(out,
		   "s/time: seconds of computing for a unit of time of the script; cost: the same, the scene "
		   "as it is being 1. Then\nchanges of the columns of its table from the finest trial, the "
		   "largest at any look, in parts of what the column goes\nthrough in a trial; ~ no more "
		   "than round-off grows to. * nothing is both cheaper and closer. > advised\n");
	for (int c = 0; c < b->columns; c++)
		if (b->counts[c]) {
			ts_str_add(out, "# of a fix that counts or measures steps, so another thing with "
					"another step: not judged\n");
			break;
		}
	if (*b->counters)
		ts_str_addf(out,
			    "with another step, these numbers of steps were changed to stand for the same "
			    "time: %s\n",
			    b->counters);
	if (n < b->columns)
		ts_str_addf(out, "%d columns that change less are not shown\n", b->columns - n);
}

static void add_head(const struct ts_board *b, struct ts_str *out)
{
	double span = (double)b->steps * b->dt;

	ts_str_addf(out, "Trials start at step %" PRId64 ", time %g, %s, with %" PRId64 " particles\n",
		    b->step, b->time, b->place, b->particles);
	ts_str_addf(out, "Each goes through %g of time, %" PRId64 " steps of %g", span, b->steps, b->dt);
	if (b->whole > 0)
		ts_str_addf(out, ": %.2g %% of the run", 100 * (double)b->steps / (double)b->whole);
	if (isfinite(b->limit))
		ts_str_addf(out, "; limit of the step %.4g", b->limit);
	ts_str_addf(out, "\nThe same again: -advise at %" PRId64 " steps %" PRId64 "\n\n", b->step, b->steps);
}

static void add_change(const struct ts_board *b, double worst, int column, struct ts_str *out)
{
	if (column < 0)
		ts_str_add(out, "nothing changes");
	else
		ts_str_addf(out, "the largest change is %.2g %% (%s)", 100 * worst, b->title[column]);
}

static void add_duration(const struct ts_board *b, const struct ts_trial *here, const struct ts_trial *t,
			 struct ts_str *out)
{
	double per_run = (double)b->left / (double)b->steps;

	ts_str_add(out, "the rest of the run would take ");
	ts_price_time(per_run * t->seconds, out);
	ts_str_add(out, " instead of ");
	ts_price_time(per_run * here->seconds, out);
}

/* What could not be told: settings that seem cheaper. */
static int add_undecided(const struct ts_board *b, struct ts_str *out)
{
	bool idle = false;
	int n = 0;

	for (int k = 0; k < b->n; k++) {
		const struct ts_trial *t = &b->trial[k];

		if (t->idle && !idle)
			ts_str_add(out, "laws of contacts: not decided, since nothing touched in the trials; "
					"begin them later (-advise at STEP)\n");
		idle |= t->idle;
		if (t->undecided)
			ts_str_addf(out,
				    "%s: not decided, %.2f of the cost, but times of the same differ by %.2g "
				    "%%; give it more time\n",
				    t->label, t->seconds / present_seconds(b), 100 * time_noise(b, t));
		n += t->undecided;
	}
	return n + idle;
}

static void add_advice(const struct ts_board *b, double tolerance, struct ts_str *out)
{
	const struct ts_trial *here = first_of(b, TS_SUBJECT_PRESENT), *all = NULL, *only = NULL;
	bool step_advised = false;
	int n = 0;

	for (int k = 0; k < b->n && here; k++) {
		const struct ts_trial *t = &b->trial[k];
		bool step = t->subject == TS_SUBJECT_STEP;
		double worst = t->worst;
		int column = t->worst_column;

		all = t->subject == TS_SUBJECT_TOGETHER && t->done ? t : all;
		if (!t->advised)
			continue;
		if (!step)
			worst = worst_change(b, t, here, &column);
		ts_str_addf(out, "%s: %.2f of the cost, ", t->label, t->seconds / here->seconds);
		add_change(b, worst, column, out);
		ts_str_addf(out, "%s\n",
			    step && here->worst > tolerance
				    ? "; the present step is too long for the tolerance"
				    : "");
		only = t;
		step_advised |= step;
		n++;
	}
	if (here && here->worst > tolerance && !step_advised)
		ts_str_addf(out,
			    "The step decides: as it is, %s is off by %.2g %%, and no step tried is within "
			    "%g %% of the finest. Try smaller ones.\n",
			    b->title[here->worst_column], 100 * here->worst, 100 * tolerance);
	else if (!add_undecided(b, out) && !n)
		ts_str_add(out, "Nothing that was tried is better than what the script has.\n");
	only = all ? all : n == 1 ? only : NULL;
	if (!only)
		return;
	ts_str_add(out, all ? "Together: " : "With it ");
	add_duration(b, here, only, out);
	ts_str_add(out, "; to the finest, ");
	add_change(b, only->worst, only->worst_column, out);
	ts_str_add(out, "\n");
}

void ts_verdict_print(struct ts_board *b, double tolerance, struct ts_str *out)
{
	measure(b);
	mark_front(b);
	add_head(b, out);
	add_table(b, out);
	ts_str_add(out, "\n");
	add_advice(b, tolerance, out);
}
