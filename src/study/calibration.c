#include "study/calibration.h"

#include <math.h>

#include "base/banned.h"

enum ts_status ts_calibration_add_values(struct ts_calibration *c, const char *const *value, size_t *index)
{
	struct ts_study *s = &c->study;
	struct ts_calibration_point p = { 0 };

	for (*index = 0; *index < c->points; ++*index) {
		bool same = true;

		for (size_t j = 0; j < c->n && same; j++)
			same = ts_streq(c->point[*index].value[c->varied[j]], value[c->varied[j]]);
		if (same)
			return TS_OK;
	}
	p.value = ts_arena_alloc(&s->arena, s->words.variables + 1, sizeof *p.value);
	if (!p.value || TS_GROW(c->point, c->capacity, c->points + 1) != TS_OK)
		return ts_nomem(&s->sim->error);
	for (size_t v = 0; v < s->words.variables; v++) {
		const struct ts_study_variable *variable = &s->words.variable[v];

		p.value[v] = variable->role == TS_STUDY_VARIED ? value[v]
			     : variable->n		       ? variable->value[0]
							       : "";
	}
	for (size_t j = 0; j < c->n; j++) {
		double number = 1;

		ts_parse_real(value[c->varied[j]], &number);
		p.x[j] = log(number);
	}
	TS_TRY(ts_study_tie(s, p.value));
	c->point[c->points++] = p;
	return TS_OK;
}

enum ts_status ts_calibration_add(struct ts_calibration *c, const double *x, size_t *index)
{
	struct ts_study *s = &c->study;
	const char **value = ts_arena_alloc(&s->arena, s->words.variables + 1, sizeof *value);

	if (!value)
		return ts_nomem(&s->sim->error);
	for (size_t j = 0; j < c->n; j++) {
		const struct ts_study_variable *v = &s->words.variable[c->varied[j]];

		/* exp(log(x)) may be beyond the bound by round-off */
		value[c->varied[j]] = ts_study_words_number(&s->words, fmax(v->lo, fmin(v->hi, exp(x[j]))));
		if (!value[c->varied[j]])
			return ts_nomem(&s->sim->error);
	}
	return ts_calibration_add_values(c, value, index);
}

static const char *replicate_value(const struct ts_calibration *c, size_t replicate)
{
	return c->study.words.variable[c->replicate].value[replicate];
}

enum ts_status ts_calibration_tasks(struct ts_calibration *c, size_t point, size_t replicates,
				    struct ts_study_task **task, size_t *n)
{
	struct ts_study *s = &c->study;
	size_t variables = s->words.variables;
	struct ts_study_task *t = ts_arena_alloc(&s->arena, replicates * s->scripts, sizeof *t);

	*task = t;
	*n = replicates * s->scripts;
	if (!t)
		return ts_nomem(&s->sim->error);
	for (size_t k = 0; k < *n; k++) {
		t[k].script = k % s->scripts;
		t[k].value = ts_arena_alloc(&s->arena, variables + 1, sizeof *t[k].value);
		if (!t[k].value)
			return ts_nomem(&s->sim->error);
		for (size_t v = 0; v < variables; v++)
			t[k].value[v] = c->point[point].value[v];
		if (c->replicate != SIZE_MAX)
			t[k].value[c->replicate] = replicate_value(c, k / s->scripts);
		TS_TRY(ts_study_tie(s, t[k].value));
	}
	return TS_OK;
}

/* Row of a script at a point and replicate; NULL: none. */
static const struct ts_study_run *find_run(const struct ts_calibration *c, size_t point, size_t replicate,
					   size_t script)
{
	const struct ts_study *s = &c->study;

	for (size_t k = 0; k < s->runs.n; k++) {
		const struct ts_study_run *run = &s->runs.run[k];
		bool same = run->status == 0 && ts_streq(run->script, s->script[script].path);

		for (size_t v = 0; v < s->words.variables && same; v++) {
			const char *value =
				v == c->replicate ? replicate_value(c, replicate) : c->point[point].value[v];

			same = ts_streq(run->value[v], s->uses[script * s->words.variables + v] ? value : "");
		}
		if (same)
			return run;
	}
	return NULL;
}

bool ts_calibration_value(const struct ts_calibration *c, size_t point, size_t replicate, size_t target,
			  double *value)
{
	const struct ts_study *s = &c->study;
	size_t result = ts_study_runs_result(&s->runs, s->words.target[target].name);

	for (size_t f = 0; f < s->scripts && result != SIZE_MAX; f++) {
		const struct ts_study_run *run = find_run(c, point, replicate, f);

		if (run && ts_study_runs_value(run, result, value))
			return true;
	}
	return false;
}

/* A result of the other sign, or 0, has no logarithm: it is as good as none. */
static bool add_logarithm(double value, double target, double *f)
{
	*f = value / target > 0 ? log(value / target) : 0;
	return value / target > 0;
}

bool ts_calibration_sample(const struct ts_calibration *c, size_t point, size_t replicate, double *f)
{
	for (size_t k = 0; k < c->study.words.targets; k++) {
		double value;

		if (!ts_calibration_value(c, point, replicate, k, &value) ||
		    !add_logarithm(value, c->study.words.target[k].value, &f[k]))
			return false;
	}
	return true;
}

bool ts_calibration_means(const struct ts_calibration *c, size_t point, double *f)
{
	for (size_t k = 0; k < c->study.words.targets; k++) {
		double value, sum = 0;

		for (size_t r = 0; r < c->replicates; r++) {
			if (!ts_calibration_value(c, point, r, k, &value))
				return false;
			sum += value;
		}
		if (!add_logarithm(sum / (double)c->replicates, c->study.words.target[k].value, &f[k]))
			return false;
	}
	return true;
}
