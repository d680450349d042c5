/* The report of a calibration: what was found, how far it is from the targets, and what the results depend on. */
#include <math.h>

#include "study/calibration.h"
#include "study/study_summary.h"

#include "base/banned.h"

/* A target with smaller sensitivities depends on none of the variables. */
static const double INSENSITIVE = 0.02;

static const char *ends[] = {
	[TS_CALIBRATION_REACHED] = "All targets are reached",
	[TS_CALIBRATION_NO_STEP] =
		"Not all targets can be reached: no step brings the results nearer to them",
	[TS_CALIBRATION_TOO_LONG] = "Not all targets are reached by the number of steps that is tried",
};

static void add_variables(const struct ts_calibration *c, struct ts_str *text)
{
	const struct ts_study_words *w = &c->study.words;

	ts_str_addf(text, "\n%-16s %12s %12s   bounds\n", "variable", "start", "found");
	for (size_t k = 0; k < w->variables; k++) {
		const struct ts_study_variable *v = &w->variable[k];
		const char *found = c->point[c->best].value[k];
		double value;

		if (v->role == TS_STUDY_TIED)
			ts_str_addf(text, "%-16s %12s %12s   %g times %s\n", v->name, "", found, v->factor,
				    w->variable[v->tied].name);
		if (v->role != TS_STUDY_VARIED)
			continue;
		ts_parse_real(found, &value);
		ts_str_addf(text, "%-16s %12.6g %12.6g   %g to %g%s\n", v->name, v->start, value, v->lo,
			    v->hi,
			    value <= v->lo * (1 + 1e-6)	  ? ", found at its lower bound"
			    : value >= v->hi * (1 - 1e-6) ? ", found at its upper bound"
							  : "");
	}
}

/* The values of a target, or their titles, in all replicates. */
static void add_replicates(const struct ts_calibration *c, size_t target, bool title, struct ts_str *text)
{
	const struct ts_study_words *w = &c->study.words;

	for (size_t r = 0; r < c->replicates && c->replicate != SIZE_MAX; r++) {
		struct ts_str cell = { 0 };
		double value = 0;

		if (title)
			ts_str_addf(&cell, "%s=%s", w->variable[c->replicate].name,
				    w->variable[c->replicate].value[r]);
		else if (ts_calibration_value(c, c->best, r, target, &value))
			ts_str_addf(&cell, "%.5g", value);
		ts_str_addf(text, "  %-10s", ts_str_text(&cell));
		ts_str_release(&cell);
	}
	ts_str_add(text, "\n");
}

static void add_targets(const struct ts_calibration *c, struct ts_str *text)
{
	const struct ts_study_words *w = &c->study.words;

	ts_str_addf(text, "\n%-16s %10s %10s %9s %9s", "target", "wanted", "mean", "error", "off by");
	add_replicates(c, 0, true, text);
	for (size_t k = 0; k < w->targets; k++) {
		const struct ts_study_target *t = &w->target[k];
		double sum = 0, squares = 0, n = (double)c->replicates, value = 0, mean;

		for (size_t r = 0; r < c->replicates; r++) {
			ts_calibration_value(c, c->best, r, k, &value);
			sum += value;
			squares += value * value;
		}
		mean = sum / n;
		ts_str_addf(text, "%-16s %10.5g %10.5g", t->name, t->value, mean);
		if (n > 1)
			ts_str_addf(text, " %9.2g", sqrt(fmax(0, squares / n - mean * mean) / (n - 1)));
		else
			ts_str_addf(text, " %9s", "-");
		ts_str_addf(text, " %7.2f %%", 100 * (mean / t->value - 1));
		add_replicates(c, k, false, text);
	}
}

static void add_sensitivities(const struct ts_calibration *c, struct ts_str *text)
{
	const struct ts_study_words *w = &c->study.words;

	if (!c->has_jacobian) {
		ts_str_add(text, "\nSensitivities were not needed, so they are not known.\n");
		return;
	}
	ts_str_addf(text, "\nd ln(result) / d ln(variable)\n%-16s", "");
	for (size_t j = 0; j < c->n; j++)
		ts_str_addf(text, " %12s", w->variable[c->varied[j]].name);
	ts_str_add(text, "\n");
	for (size_t k = 0; k < w->targets; k++) {
		double most = 0;

		ts_str_addf(text, "%-16s", w->target[k].name);
		for (size_t j = 0; j < c->n; j++) {
			double slope = c->jacobian[k * c->n + j];

			most = fmax(most, fabs(slope));
			ts_str_addf(text, " %12.3f", fabs(slope) < 5e-4 ? 0 : slope);
		}
		ts_str_add(text, most < INSENSITIVE ? "   depends on none of the variables\n" : "\n");
	}
}

/* Means of all results that are no targets. */
static void add_other_results(struct ts_calibration *c, struct ts_str *text)
{
	struct ts_study *s = &c->study;
	struct ts_study_task *task;
	size_t n, shown = 0;

	if (ts_calibration_tasks(c, c->best, c->replicates, &task, &n) != TS_OK ||
	    ts_study_run_all(s, task, n) != TS_OK)
		return;
	for (size_t r = 0; r < s->runs.results; r++) {
		struct ts_study_mean m = ts_study_summary_mean(s, task, n, 0, r);
		bool target = false;

		for (size_t k = 0; k < s->words.targets; k++)
			target |= ts_streq(s->words.target[k].name, s->runs.result[r]);
		if (target || !m.n)
			continue;
		ts_str_addf(text, shown++ ? "%-16s %.5g" : "\nother results\n%-16s %.5g", s->runs.result[r],
			    m.mean);
		ts_str_addf(text, isnan(m.error) ? "\n" : " +- %.2g\n", m.error);
	}
}

static void add_verdicts(const struct ts_calibration *c, struct ts_str *text)
{
	const struct ts_study_words *w = &c->study.words;

	ts_str_add(text, "\n");
	for (size_t k = 0; k < w->targets; k++) {
		const struct ts_study_target *t = &w->target[k];
		double value = t->value * exp(c->f[k]);

		ts_str_addf(text, "RESULT %s %.5g %.5g %.3g %s\n", t->name, value, t->value,
			    t->tolerance * fabs(t->value),
			    fabs(value / t->value - 1) <= t->tolerance ? "ok" : "off");
	}
	ts_str_add(text, "\n  -var");
	for (size_t k = 0, n = 0; k < w->variables; k++)
		if (w->variable[k].role == TS_STUDY_VARIED || w->variable[k].role == TS_STUDY_TIED)
			ts_str_addf(text, "%s %s %s", n++ ? " -var" : "", w->variable[k].name,
				    c->point[c->best].value[k]);
	ts_str_add(text, "\n");
}

void ts_calibration_report(struct ts_calibration *c, struct ts_str *text)
{
	ts_str_addf(text, "\n%s: %zu points, %zu runs now, %zu in %s\n", ends[c->end], c->tried,
		    c->study.started, c->study.runs.n, c->study.table);
	add_variables(c, text);
	add_targets(c, text);
	add_sensitivities(c, text);
	add_other_results(c, text);
	add_verdicts(c, text);
}
