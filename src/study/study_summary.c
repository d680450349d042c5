#include "study/study_summary.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "io/csv.h"

#include "base/banned.h"

enum { BLOCK = 5 /* results side by side in the table */, CELL = 24 };

static bool is_first_with_run(const struct ts_study_task *task, size_t k)
{
	for (size_t j = 0; j < k; j++)
		if (task[j].run == task[k].run && task[j].group == task[k].group)
			return false;
	return true;
}

struct ts_study_mean ts_study_summary_mean(const struct ts_study *s, const struct ts_study_task *task,
					   size_t n, size_t group, size_t result)
{
	struct ts_study_mean m = { .error = NAN };
	double squares = 0, value;

	for (size_t k = 0; k < n; k++) {
		double before = m.mean;

		if (task[k].group != group || task[k].run == SIZE_MAX ||
		    !ts_study_runs_value(&s->runs.run[task[k].run], result, &value) ||
		    !is_first_with_run(task, k))
			continue;
		m.mean += (value - m.mean) / (double)++m.n;
		squares += (value - before) * (value - m.mean);
	}
	if (m.n > 1)
		m.error = sqrt(squares / (double)(m.n - 1) / (double)m.n);
	return m;
}

bool ts_study_summary_has(const struct ts_study *s, const struct ts_study_task *task, size_t n, size_t result)
{
	double value;

	for (size_t k = 0; k < n; k++)
		if (task[k].run != SIZE_MAX && ts_study_runs_value(&s->runs.run[task[k].run], result, &value))
			return true;
	return false;
}

/* Whether a run of the script of this path prints the result. */
static bool prints(const struct ts_study *s, const char *script, size_t result)
{
	for (size_t k = 0; k < s->runs.n; k++) {
		const struct ts_study_run *run = &s->runs.run[k];

		if (ts_streq(run->script, script) && result < run->results && *run->result[result])
			return true;
	}
	return false;
}

enum ts_status ts_study_summary_check_names(struct ts_study *s)
{
	for (size_t r = 0; r < s->runs.results && s->scripts > 1; r++) {
		const char *first = NULL;

		for (size_t f = 0; f < s->scripts; f++) {
			if (!prints(s, s->script[f].path, r))
				continue;
			if (first)
				return ts_fail(&s->sim->error, TS_STATE, NULL,
					       "both %s and %s print the result '%s': give it another name "
					       "in one of them",
					       first, s->script[f].path, s->runs.result[r]);
			first = s->script[f].path;
		}
	}
	return TS_OK;
}

static bool is_listed(const struct ts_study_variable *v)
{
	return v->role == TS_STUDY_SWEPT || v->role == TS_STUDY_TIED || v->role == TS_STUDY_VARIED;
}

static void write_csv(struct ts_study *s, const struct ts_study_task *task, size_t n,
		      const char **const *label, size_t groups, struct ts_str *out)
{
	const char *comma = "";

	for (size_t v = 0; v < s->words.variables; v++) {
		if (!is_listed(&s->words.variable[v]))
			continue;
		ts_str_addf(out, "%s%s", comma, s->words.variable[v].name);
		comma = ",";
	}
	for (size_t r = 0; r < s->runs.results; r++) {
		if (!ts_study_summary_has(s, task, n, r))
			continue;
		ts_str_add(out, comma);
		for (int k = 0; k < 3; k++) {
			static const char *const ending[] = { "", "_error", "_runs" };
			struct ts_str name = { 0 };

			ts_str_addf(&name, "%s%s", s->runs.result[r], ending[k]);
			ts_str_add(out, k ? "," : "");
			ts_csv_add_cell(out, ts_str_text(&name));
			ts_str_release(&name);
		}
		comma = ",";
	}
	for (size_t g = 0; g < groups; g++) {
		comma = "\n";
		for (size_t v = 0; v < s->words.variables; v++) {
			if (!is_listed(&s->words.variable[v]))
				continue;
			ts_str_add(out, comma);
			ts_csv_add_cell(out, label[g][v]);
			comma = ",";
		}
		for (size_t r = 0; r < s->runs.results; r++) {
			struct ts_study_mean m = ts_study_summary_mean(s, task, n, g, r);

			if (!ts_study_summary_has(s, task, n, r))
				continue;
			ts_str_add(out, comma);
			if (m.n)
				ts_str_addf(out, "%.9g", m.mean);
			ts_str_add(out, ",");
			if (!isnan(m.error))
				ts_str_addf(out, "%.9g", m.error);
			ts_str_addf(out, ",%zu", m.n);
			comma = ",";
		}
	}
	ts_str_add(out, "\n");
}

static size_t width_of(const struct ts_study *s, size_t v, const char **const *label, size_t groups)
{
	size_t width = strlen(s->words.variable[v].name);

	for (size_t g = 0; g < groups; g++)
		width = strlen(label[g][v]) > width ? strlen(label[g][v]) : width;
	return width;
}

/* `runs`: of which some may have failed, or have printed no number. */
static void add_mean(const struct ts_study_mean *m, size_t runs, struct ts_str *out)
{
	struct ts_str cell = { 0 };

	if (!m->n)
		ts_str_add(&cell, "-");
	else
		ts_str_addf(&cell, isnan(m->error) ? "%.5g" : "%.5g +- %.2g", m->mean, m->error);
	if (m->n && m->n < runs)
		ts_str_addf(&cell, " (%zu)", m->n);
	ts_str_addf(out, "  %-*s", CELL, ts_str_text(&cell));
	ts_str_release(&cell);
}

/* Number of runs of the group whose script prints the result. */
static size_t count_runs(const struct ts_study *s, const struct ts_study_task *task, size_t n, size_t group,
			 size_t result)
{
	size_t count = 0;

	for (size_t k = 0; k < n; k++)
		count += task[k].group == group && task[k].run != SIZE_MAX && is_first_with_run(task, k) &&
			 prints(s, s->runs.run[task[k].run].script, result);
	return count;
}

/* The table of a block of results. */
static void add_block(const struct ts_study *s, const struct ts_study_task *task, size_t n,
		      const char **const *label, size_t groups, const size_t *result, size_t results,
		      struct ts_str *text)
{
	for (size_t g = 0; g <= groups; g++) { /* 0: the head */
		for (size_t v = 0; v < s->words.variables; v++)
			if (is_listed(&s->words.variable[v]))
				ts_str_addf(text, "%-*s  ", (int)width_of(s, v, label, groups),
					    g ? label[g - 1][v] : s->words.variable[v].name);
		for (size_t k = 0; k < results; k++) {
			struct ts_study_mean m;

			if (!g) {
				ts_str_addf(text, "  %-*s", CELL, s->runs.result[result[k]]);
				continue;
			}
			m = ts_study_summary_mean(s, task, n, g - 1, result[k]);
			add_mean(&m, count_runs(s, task, n, g - 1, result[k]), text);
		}
		ts_str_add(text, "\n");
	}
}

/* One variable with numbers: a chart of all results against it. */
static enum ts_status write_plot(struct ts_study *s, const struct ts_study_task *task, size_t n,
				 const char **const *label, size_t groups)
{
	struct ts_str text = { 0 };
	size_t swept = 0, at = 0, column = 0, charts = 0;
	bool numbers = groups > 1;
	enum ts_status status;
	double value;

	for (size_t v = 0; v < s->words.variables; v++) {
		swept += is_listed(&s->words.variable[v]);
		if (s->words.variable[v].role == TS_STUDY_SWEPT)
			at = v;
	}
	for (size_t g = 0; g < groups; g++)
		numbers &= ts_parse_real(label[g][at], &value);
	for (size_t r = 0; r < s->runs.results; r++)
		charts += ts_study_summary_has(s, task, n, r);
	if (swept != 1 || !numbers || !charts)
		return TS_OK;
	ts_str_addf(&text,
		    "# in this folder: gnuplot plot.gp\nset terminal pngcairo size 560, %zu\nset output "
		    "'gnuplot.png'\n"
		    "set datafile separator ','\nset multiplot layout %zu, 1\nset xlabel '%s' "
		    "noenhanced\nunset key\n",
		    320 * charts, charts, s->words.variable[at].name);
	for (size_t r = 0; r < s->runs.results; r++)
		if (ts_study_summary_has(s, task, n, r)) {
			column++;
			ts_str_addf(&text,
				    "set ylabel '%s' noenhanced\nplot 'summary.csv' using "
				    "1:%zu:(column(%zu)) with yerrorlines pt 7\n",
				    s->runs.result[r], 3 * column - 1, 3 * column);
		}
	ts_str_add(&text, "unset multiplot\n");
	status = ts_study_write(s, "plot.gp", &text);
	ts_str_release(&text);
	return status;
}

enum ts_status ts_study_summary_write(struct ts_study *s, const struct ts_study_task *task, size_t n,
				      const char **const *label, size_t groups, struct ts_str *text)
{
	struct ts_str csv = { 0 };
	size_t block[BLOCK], wide = 0;
	enum ts_status status;

	write_csv(s, task, n, label, groups, &csv);
	status = ts_study_write(s, "summary.csv", &csv);
	ts_str_release(&csv);
	TS_TRY(status);
	for (size_t r = 0; r < s->runs.results; r++) {
		if (ts_study_summary_has(s, task, n, r))
			block[wide++] = r;
		if (wide == BLOCK || (wide && r + 1 == s->runs.results)) {
			ts_str_add(text, "\n");
			add_block(s, task, n, label, groups, block, wide, text);
			wide = 0;
		}
	}
	return write_plot(s, task, n, label, groups);
}

size_t ts_study_summary_failures(const struct ts_study *s, const struct ts_study_task *task, size_t n,
				 struct ts_str *text)
{
	size_t failed = 0;

	for (size_t k = 0; k < n; k++) {
		const struct ts_study_run *run = task[k].run == SIZE_MAX ? NULL : &s->runs.run[task[k].run];

		if (!run || !run->status || !is_first_with_run(task, k))
			continue;
		ts_str_addf(text, failed++ ? "run %" PRId64 " failed (" : "\nrun %" PRId64 " failed (",
			    run->number);
		ts_study_name_values(s, run->value, text);
		ts_str_addf(text, "), exit status %d: %s\n", run->status, run->error);
	}
	return failed;
}
