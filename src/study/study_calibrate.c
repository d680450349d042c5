/* `tsim -calibrate`: variables for which results hit their targets.
 *
 * Gauss-Newton in the logarithms of variables and results, with a matrix of secants from all runs that are known: pairs
 * of runs of the same replicate (secant.h). The first matrix needs a run for each variable, beside the start and in the
 * first replicate. The length of steps is limited by a trust region. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/calibration.h"
#include "study/study_summary.h"

#include "base/banned.h"

/* In logarithms: first and longest step; the shortest one worth a run; the step of differences; how far runs may be to
 * count for the matrix; the scatter of results by rounding and chance. */
static const double RADIUS = 0.7, LONGEST = 1.4, SHORTEST = 0.02, DIFFERENCE = 0.15, REACH = 5, NOISE = 0.01;
/* A step is worth its runs if it should decrease the distance to the targets to this part. */
static const double WORTH = 0.9;
static const double TOLERANCE = 0.05;
enum { MOST_POINTS = 40, MOST_TARGETS = 64 };

static enum ts_status parse(struct ts_calibration *c)
{
	struct ts_study *s = &c->study;
	const struct ts_study_input *in = s->in;
	struct ts_error *err = &s->sim->error;
	double tolerance = isnan(in->tolerance) ? TOLERANCE : in->tolerance;

	TS_TRY(ts_study_words_targets(&s->words, in->calibrate, tolerance, err));
	TS_TRY(ts_study_words_variables(&s->words, "-vary", TS_STUDY_VARIED, in->vary, err));
	TS_TRY(ts_study_words_variables(&s->words, "-replicate", TS_STUDY_REPLICATE, in->replicate, err));
	TS_TRY(ts_study_words_fixed(&s->words, in->vars, err));
	c->replicate = SIZE_MAX;
	c->replicates = 1;
	for (size_t k = 0; k < s->words.variables; k++) {
		const struct ts_study_variable *v = &s->words.variable[k];

		if (v->role == TS_STUDY_REPLICATE && c->replicate != SIZE_MAX)
			return ts_study_misuse(s, "-replicate takes one variable");
		if (v->role == TS_STUDY_REPLICATE) {
			c->replicate = k;
			c->replicates = v->n;
		}
		if (v->role == TS_STUDY_VARIED && c->n == TS_SECANT_MOST)
			return ts_study_misuse(s, "-vary takes at most %d variables", TS_SECANT_MOST);
		if (v->role == TS_STUDY_VARIED)
			c->varied[c->n++] = k;
	}
	if (!s->words.targets)
		return ts_study_misuse(s, "-calibrate needs targets: -calibrate 'NAME=VALUE ...'");
	if (s->words.targets > MOST_TARGETS)
		return ts_study_misuse(s, "-calibrate takes at most %d targets", MOST_TARGETS);
	return c->n ? TS_OK : ts_study_misuse(s, "-calibrate needs variables: -vary 'NAME=START ...'");
}

/* Why a point has no results, as an error. */
static enum ts_status explain_missing(struct ts_calibration *c, size_t point)
{
	struct ts_study *s = &c->study;
	struct ts_error *err = &s->sim->error;
	struct ts_study_task *task;
	size_t n;

	TS_TRY(ts_calibration_tasks(c, point, c->replicates, &task, &n));
	TS_TRY(ts_study_run_all(s, task, n));
	for (size_t k = 0; k < n; k++) {
		const struct ts_study_run *run = task[k].run == SIZE_MAX ? NULL : &s->runs.run[task[k].run];

		if (!run || run->status)
			return ts_fail(err, TS_STATE, NULL, "run %lld of %s failed with exit status %d: %s",
				       run ? (long long)run->number : 0, s->script[task[k].script].path,
				       run ? run->status : -1, run ? run->error : "ended by a signal");
	}
	for (size_t k = 0; k < s->words.targets; k++) {
		const struct ts_study_target *t = &s->words.target[k];
		size_t result = ts_study_runs_result(&s->runs, t->name);
		struct ts_suggest suggest = ts_suggest_start(t->name);
		double value;

		for (size_t r = 0; r < s->runs.results; r++)
			ts_suggest_try(&suggest, s->runs.result[r]);
		if (result == SIZE_MAX)
			return ts_study_misuse(s,
					       "-calibrate: no line RESULT or STUDY of the runs has the "
					       "target '%s'%s",
					       t->name, ts_suggest_text(&suggest));
		for (size_t r = 0; r < c->replicates; r++)
			if (!ts_calibration_value(c, point, r, k, &value))
				return ts_fail(err, TS_STATE, NULL,
					       "a run does not print the target '%s' as a number: see its "
					       "column in %s",
					       t->name, s->table);
	}
	return ts_fail(err, TS_STATE, NULL,
		       "a result and its target have different signs, or the result is 0: see %s", s->table);
}

static void print_point(const struct ts_calibration *c, const double *f)
{
	struct ts_str text = { 0 };

	ts_str_addf(&text, "point %zu:", c->tried);
	for (size_t k = 0; k < c->study.words.targets; k++)
		ts_str_addf(&text, " %s %+.2f %%", c->study.words.target[k].name, 100 * expm1(f[k]));
	ts_log(&c->study.sim->log, "%s\n", ts_str_text(&text));
	ts_str_release(&text);
}

/* Runs all replicates of a point; *good: the results are there. */
static enum ts_status evaluate(struct ts_calibration *c, size_t point, double *f, bool *good)
{
	struct ts_study_task *task;
	size_t n;

	TS_TRY(ts_calibration_tasks(c, point, c->replicates, &task, &n));
	TS_TRY(ts_study_run_all(&c->study, task, n));
	TS_TRY(ts_study_summary_check_names(&c->study));
	*good = ts_calibration_means(c, point, f);
	c->tried++;
	if (*good)
		print_point(c, f);
	else
		ts_log(&c->study.sim->log, "point %zu: not all results\n", c->tried);
	return TS_OK;
}

/* Distance to the targets in units of their tolerances. */
static double distance(const struct ts_calibration *c, const double *f)
{
	double sum = 0;

	for (size_t k = 0; k < c->study.words.targets; k++) {
		double r = f[k] / c->study.words.target[k].tolerance;

		sum += r * r;
	}
	return sqrt(sum);
}

static bool reached(const struct ts_calibration *c, const double *f)
{
	bool all = true;

	for (size_t k = 0; k < c->study.words.targets; k++)
		all &= fabs(expm1(f[k])) <= c->study.words.target[k].tolerance;
	return all;
}

static void accept(struct ts_calibration *c, size_t point, const double *f)
{
	c->best = point;
	c->fresh = false;
	memcpy(c->f, f, c->study.words.targets * sizeof *f);
}

/* Points of the table: what is known from studies before this one. */
static enum ts_status remember_points(struct ts_calibration *c)
{
	const struct ts_study_runs *runs = &c->study.runs;
	size_t index;

	for (size_t k = 0; k < runs->n; k++) {
		bool whole = runs->run[k].status == 0;
		double value;

		for (size_t j = 0; j < c->n && whole; j++)
			whole = ts_parse_real(runs->run[k].value[c->varied[j]], &value) && value > 0;
		if (whole)
			TS_TRY(ts_calibration_add_values(c, runs->run[k].value, &index));
	}
	return TS_OK;
}

static bool within_bounds(const struct ts_calibration *c, size_t point)
{
	bool within = true;

	for (size_t j = 0; j < c->n; j++) {
		const struct ts_study_variable *v = &c->study.words.variable[c->varied[j]];
		double value = exp(c->point[point].x[j]);

		within &= value >= v->lo * (1 - 1e-8) && value <= v->hi * (1 + 1e-8);
	}
	return within;
}

/* The start, or the best known point. */
static enum ts_status begin(struct ts_calibration *c)
{
	double x[TS_SECANT_MOST], *f = ts_arena_alloc(&c->study.arena, c->study.words.targets, sizeof *f);
	size_t start;
	bool good;

	if (!f)
		return ts_nomem(&c->study.sim->error);
	TS_TRY(remember_points(c));
	for (size_t k = 0; k < c->points; k++)
		if (within_bounds(c, k) && ts_calibration_means(c, k, f) &&
		    !(distance(c, f) >= distance(c, c->f)))
			accept(c, k, f);
	if (isfinite(c->f[0])) {
		memcpy(f, c->f, c->study.words.targets * sizeof *f);
		return evaluate(c, c->best, f, &good); /* prints it */
	}
	for (size_t j = 0; j < c->n; j++)
		x[j] = log(c->study.words.variable[c->varied[j]].start);
	TS_TRY(ts_calibration_add(c, x, &start));
	TS_TRY(evaluate(c, start, f, &good));
	if (!good)
		return explain_missing(c, start);
	accept(c, start, f);
	return TS_OK;
}

/* The matrix at the best point from the runs that are known; TS_RANGE: they are too few. */
static enum ts_status fit_jacobian(struct ts_calibration *c, bool keep)
{
	size_t m = c->study.words.targets, pairs = 0, most = c->points * c->replicates;
	struct ts_secant_pair *pair = ts_alloc(most + 1, sizeof *pair);
	double *df = ts_alloc((most + 1) * m, sizeof *df), *f = ts_alloc(m, sizeof *f);
	enum ts_status status = pair && df && f ? TS_OK : TS_NOMEM;

	for (size_t r = 0; r < c->replicates && status == TS_OK; r++) {
		if (!ts_calibration_sample(c, c->best, r, f))
			continue;
		for (size_t k = 0; k < c->points; k++) {
			struct ts_secant_pair *p = &pair[pairs];
			double *to = df + pairs * m, length = 0;

			for (size_t j = 0; j < c->n; j++) {
				p->dx[j] = c->point[k].x[j] - c->point[c->best].x[j];
				length = fmax(length, fabs(p->dx[j]));
			}
			if (k == c->best || length > REACH || !ts_calibration_sample(c, k, r, to))
				continue;
			for (size_t t = 0; t < m; t++)
				to[t] -= f[t];
			p->df = to;
			pairs++;
		}
	}
	if (status == TS_OK)
		status = ts_secant_jacobian(pair, pairs, c->n, m, NOISE, keep, c->jacobian);
	ts_free(pair);
	ts_free(df);
	ts_free(f);
	return status == TS_NOMEM ? ts_nomem(&c->study.sim->error) : status;
}

/* The point beside the best one in the direction of a variable, upwards or downwards. */
static enum ts_status add_neighbour(struct ts_calibration *c, size_t j, bool down, size_t *point)
{
	const struct ts_study_variable *v = &c->study.words.variable[c->varied[j]];
	double x[TS_SECANT_MOST], step = fmin(DIFFERENCE, 0.5 * log(v->hi / v->lo));

	memcpy(x, c->point[c->best].x, sizeof x);
	if (down ? x[j] - step < log(v->lo) : x[j] + step > log(v->hi))
		down = !down;
	x[j] += down ? -step : step;
	return ts_calibration_add(c, x, point);
}

/* Runs beside the best point, one for each variable, in the first replicate; where one fails, on the other side. */
static enum ts_status run_differences(struct ts_calibration *c)
{
	size_t point[TS_SECANT_MOST], n = 0, count;
	struct ts_study_task *all = ts_arena_alloc(&c->study.arena, c->n * c->study.scripts, sizeof *all),
			     *task;
	double *f = ts_arena_alloc(&c->study.arena, c->study.words.targets, sizeof *f);

	if (!all || !f)
		return ts_nomem(&c->study.sim->error);
	for (int down = 0; down < 2; down++) {
		n = 0;
		for (size_t j = 0; j < c->n; j++) {
			if (down && ts_calibration_sample(c, point[j], 0, f))
				continue;
			TS_TRY(add_neighbour(c, j, down, &point[j]));
			TS_TRY(ts_calibration_tasks(c, point[j], 1, &task, &count));
			memcpy(all + n, task, count * sizeof *task);
			n += count;
		}
		TS_TRY(ts_study_run_all(&c->study, all, n));
	}
	c->fresh = true;
	return TS_OK;
}

static enum ts_status update_jacobian(struct ts_calibration *c, bool measure)
{
	enum ts_status status = TS_RANGE;

	if (!measure)
		status = fit_jacobian(c, c->has_jacobian);
	if (status == TS_RANGE) {
		TS_TRY(run_differences(c));
		status = fit_jacobian(c, false);
		if (status == TS_RANGE)
			status =
				ts_fail(&c->study.sim->error, TS_STATE, NULL,
					"too few runs beside the start have results: see %s", c->study.table);
	}
	c->has_jacobian |= status == TS_OK;
	return status;
}

/* The next step within the trust region and the bounds; *left: distance to the targets that it should leave. */
static enum ts_status find_step(struct ts_calibration *c, double radius, double *dx, double *left)
{
	double tolerance[MOST_TARGETS], lo[TS_SECANT_MOST], hi[TS_SECANT_MOST];
	size_t m = c->study.words.targets;
	enum ts_status status;

	for (size_t k = 0; k < m; k++)
		tolerance[k] = c->study.words.target[k].tolerance;
	for (size_t j = 0; j < c->n; j++) {
		const struct ts_study_variable *v = &c->study.words.variable[c->varied[j]];
		double x = c->point[c->best].x[j];

		lo[j] = fmin(0, fmax(-radius, log(v->lo) - x));
		hi[j] = fmax(0, fmin(radius, log(v->hi) - x));
	}
	status = ts_secant_step(c->n, m, c->jacobian, c->f, tolerance, lo, hi, dx, left);
	return status == TS_OK ? TS_OK : ts_nomem(&c->study.sim->error);
}

/* Tries a step; adapts the radius. */
static enum ts_status try_step(struct ts_calibration *c, const double *dx, double left, double *radius)
{
	double x[TS_SECANT_MOST], length = 0, before = distance(c, c->f), after = INFINITY;
	double *f = ts_arena_alloc(&c->study.arena, c->study.words.targets, sizeof *f);
	size_t point;
	bool good;

	if (!f)
		return ts_nomem(&c->study.sim->error);
	for (size_t j = 0; j < c->n; j++) {
		x[j] = c->point[c->best].x[j] + dx[j];
		length = fmax(length, fabs(dx[j]));
	}
	TS_TRY(ts_calibration_add(c, x, &point));
	TS_TRY(evaluate(c, point, f, &good));
	if (good)
		after = distance(c, f);
	if (good && (after < before || reached(c, f)))
		accept(c, point, f);
	if (!(before - after > 0.25 * (before - left)))
		*radius = 0.5 * length;
	else if (before - after > 0.75 * (before - left) && length > 0.99 * *radius)
		*radius = fmin(LONGEST, 2 * *radius);
	return TS_OK;
}

static enum ts_status search(struct ts_calibration *c)
{
	double radius = RADIUS, dx[TS_SECANT_MOST], left;

	while (!reached(c, c->f)) {
		double length = 0;

		c->end = TS_CALIBRATION_TOO_LONG;
		if (c->tried >= MOST_POINTS)
			return TS_OK;
		TS_TRY(update_jacobian(c, false));
		TS_TRY(find_step(c, radius, dx, &left));
		for (size_t j = 0; j < c->n; j++)
			length = fmax(length, fabs(dx[j]));
		if (left > WORTH * distance(c, c->f) ||
		    length < fmin(SHORTEST, 0.1 * c->study.words.target[0].tolerance)) {
			c->end = TS_CALIBRATION_NO_STEP;
			if (c->fresh)
				return TS_OK;
			TS_TRY(update_jacobian(c,
					       true)); /* before that is said, the matrix is measured here */
			radius = fmax(radius, DIFFERENCE);
			continue;
		}
		TS_TRY(try_step(c, dx, left, &radius));
	}
	c->end = TS_CALIBRATION_REACHED;
	c->has_jacobian |= fit_jacobian(c, c->has_jacobian) == TS_OK;
	return TS_OK;
}

static enum ts_status run(struct ts_calibration *c)
{
	struct ts_study *s = &c->study;
	const char **first;

	s->misused = true; /* until the words are read */
	TS_TRY(parse(c));
	s->misused = false;
	first = ts_arena_alloc(&s->arena, s->words.variables + 1, sizeof *first);
	c->jacobian = ts_arena_alloc(&s->arena, s->words.targets * c->n, sizeof *c->jacobian);
	c->f = ts_arena_alloc(&s->arena, s->words.targets, sizeof *c->f);
	if (!first || !c->jacobian || !c->f)
		return ts_nomem(&s->sim->error);
	for (size_t k = 0; k < s->words.targets; k++)
		c->f[k] = INFINITY;
	for (size_t k = 0; k < s->words.variables; k++) {
		const struct ts_study_variable *v = &s->words.variable[k];

		first[k] = v->role == TS_STUDY_VARIED ? ts_study_words_number(&s->words, v->start)
			   : v->n		      ? v->value[0]
						      : "";
		if (!first[k])
			return ts_nomem(&s->sim->error);
	}
	TS_TRY(ts_study_tie(s, first));
	TS_TRY(ts_study_open(s, first));
	TS_TRY(begin(c));
	return search(c);
}

int ts_study_calibrate(struct tsim *sim, const struct ts_study_input *input)
{
	struct ts_calibration c = { .study = { .sim = sim, .in = input, .option = "-calibrate" } };
	struct ts_str text = { 0 };
	enum ts_status status = run(&c);

	if (status == TS_OK) {
		ts_calibration_report(&c, &text);
		ts_log(&sim->log, "%s", ts_str_text(&text));
		status = ts_study_write(&c.study, "report.txt", &text);
	}
	ts_str_release(&text);
	ts_free(c.point);
	return ts_study_end(&c.study, status,
			    c.end == TS_CALIBRATION_REACHED ? EXIT_SUCCESS : TS_STUDY_MISSED);
}
