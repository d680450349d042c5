#include "study/study_chart.h"

#include <math.h>

#include "view/view.h"

#include "base/banned.h"

enum { DECADES = 30 /* variables that span more are drawn on a logarithmic axis */ };

/* A swept variable with several numbers, which are those of the horizontal axis; *wide: they span decades. */
static bool has_axis(const struct ts_study *s, const char **const *label, size_t groups, bool *wide)
{
	for (size_t v = 0; v < s->words.variables; v++) {
		double least = INFINITY, largest = -INFINITY, value;
		bool numbers = s->words.variable[v].role == TS_STUDY_SWEPT;

		for (size_t g = 0; g < groups && numbers; g++) {
			numbers = ts_parse_real(label[g][v], &value);
			least = numbers ? fmin(least, value) : least;
			largest = numbers ? fmax(largest, value) : largest;
		}
		if (!numbers || !(least < largest))
			continue;
		*wide = least > 0 && largest >= DECADES * least;
		return true;
	}
	return false;
}

static bool has_results(const struct ts_study *s, const struct ts_study_task *task, size_t n)
{
	for (size_t r = 0; r < s->runs.results; r++)
		if (ts_study_summary_has(s, task, n, r))
			return true;
	return false;
}

static enum ts_status draw(struct ts_study *s, const char *ending, const char *log, struct ts_str *text)
{
	struct ts_str csv = { 0 }, picture = { 0 };
	enum ts_status status;

	ts_str_addf(&csv, "%s/summary.csv", s->folder);
	ts_str_addf(&picture, "%s/summary.%s", s->folder, ending);
	if (csv.failed || picture.failed) {
		status = ts_nomem(&s->sim->error);
	} else {
		const struct ts_view_source source = { .path = csv.text };
		const struct ts_view_input in = { .source = &source,
						  .n = 1,
						  .out = picture.text,
						  .log = log,
						  .title = s->scripts == 1 ? s->script[0].path : "" };

		status = ts_view(s->sim, &in, text);
	}
	ts_str_release(&csv);
	ts_str_release(&picture);
	return status;
}

enum ts_status ts_study_chart(struct ts_study *s, const struct ts_study_task *task, size_t n,
			      const char **const *label, size_t groups, struct ts_str *text)
{
	enum ts_status status;
	bool wide;

	if (!has_results(s, task, n)) {
		ts_str_add(text,
			   "\nno run has printed a line `RESULT NAME VALUE` or `STUDY NAME=VALUE`: there are "
			   "no results\n");
		return TS_OK;
	}
	if (!has_axis(s, label, groups, &wide))
		return TS_OK;
	status = draw(s, "svg", wide ? "x" : NULL, text);
	if (status == TS_OK)
		status = draw(s, "png", wide ? "x" : NULL, text);
	if (status != TS_RANGE && status != TS_SYNTAX)
		return status;
	ts_str_addf(text, "\nno chart is drawn: %s\n", s->sim->error.message);
	ts_error_clear(&s->sim->error);
	return TS_OK;
}
