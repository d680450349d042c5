/* `tsim -sweep`: all combinations of values of variables. */
#include <math.h>
#include <stdlib.h>

#include "study/study_batch.h"
#include "study/study_chart.h"
#include "study/study_summary.h"

#include "base/banned.h"

enum { MOST_RUNS = 10000 };

struct sweep {
	struct ts_study study;
	struct ts_study_task *task; /* [tasks] */
	const char ***label;	    /* [groups]: values of the variables */
	size_t tasks, groups;
};

static size_t count_values(const struct ts_study_variable *v)
{
	return v->role == TS_STUDY_SWEPT || v->role == TS_STUDY_REPLICATE ? v->n : 1;
}

/* -replicate NAME of a swept variable, or NAME=VALUES; without it `seed`, if that is swept. */
static enum ts_status parse_replicate(struct ts_study *s)
{
	const struct ts_study_input *in = s->in;
	const char *name = in->replicate.n ? in->replicate.word[0].text : "seed";
	size_t k = ts_study_words_find(&s->words, name), replicates = 0;

	if (k != SIZE_MAX && s->words.variable[k].role == TS_STUDY_SWEPT)
		s->words.variable[k].role = TS_STUDY_REPLICATE;
	else if (in->replicate.n)
		TS_TRY(ts_study_words_variables(&s->words, "-replicate", TS_STUDY_REPLICATE, in->replicate,
						&s->sim->error));
	for (k = 0; k < s->words.variables; k++)
		replicates += s->words.variable[k].role == TS_STUDY_REPLICATE;
	return replicates > 1 ? ts_study_misuse(s, "-replicate takes one variable") : TS_OK;
}

static enum ts_status parse(struct ts_study *s)
{
	struct ts_error *err = &s->sim->error;
	size_t swept;

	TS_TRY(ts_study_words_variables(&s->words, "-sweep", TS_STUDY_SWEPT, s->in->sweep, err));
	swept = s->words.variables;
	TS_TRY(parse_replicate(s));
	TS_TRY(ts_study_words_fixed(&s->words, s->in->vars, err));
	if (!swept)
		return ts_study_misuse(s, "-sweep needs variables and their values: -sweep 'mu=0.1:0.5:5 "
					  "seed=1,2,3'");
	return TS_OK;
}

/* The k-th combination; the last variable changes first. */
static enum ts_status combine(struct sweep *w, size_t k, size_t *group, const char ***out)
{
	struct ts_study *s = &w->study;
	const char **value = ts_arena_alloc(&s->arena, s->words.variables + 1, sizeof *value);
	size_t stride = 1;

	if (!value)
		return ts_nomem(&s->sim->error);
	*group = 0;
	for (size_t v = s->words.variables; v-- > 0;) {
		const struct ts_study_variable *variable = &s->words.variable[v];
		size_t n = count_values(variable);

		value[v] = variable->n ? variable->value[k % n] : "";
		if (variable->role == TS_STUDY_SWEPT) {
			*group += stride * (k % n);
			stride *= n;
		}
		k /= n;
	}
	*out = value;
	return ts_study_tie(s, value);
}

static enum ts_status make_tasks(struct sweep *w)
{
	struct ts_study *s = &w->study;
	double runs = 1;
	size_t combinations = 1;

	w->groups = 1;
	for (size_t v = 0; v < s->words.variables; v++) {
		runs *= (double)count_values(&s->words.variable[v]);
		if (runs > MOST_RUNS)
			return ts_study_misuse(s, "-sweep: more than %d combinations", MOST_RUNS);
		combinations *= count_values(&s->words.variable[v]);
		if (s->words.variable[v].role == TS_STUDY_SWEPT)
			w->groups *= s->words.variable[v].n;
	}
	w->task = ts_arena_alloc(&s->arena, combinations * TS_STUDY_MOST_SCRIPTS, sizeof *w->task);
	w->label = ts_arena_alloc(&s->arena, w->groups, sizeof *w->label);
	if (!w->task || !w->label)
		return ts_nomem(&s->sim->error);
	for (size_t k = 0; k < combinations; k++)
		for (size_t f = 0; f < s->in->scripts.n; f++) {
			struct ts_study_task *task = &w->task[w->tasks++];
			const char **label;

			task->script = f;
			TS_TRY(combine(w, k, &task->group, &task->value));
			TS_TRY(combine(w, k, &task->group,
				       &label)); /* a copy: values of the task are changed */
			w->label[task->group] = label;
		}
	return TS_OK;
}

static enum ts_status run(struct sweep *w, struct ts_str *text, size_t *failed)
{
	struct ts_study *s = &w->study;

	s->misused = true; /* until the words are read */
	TS_TRY(parse(s));
	s->misused = false;
	if (!s->in->scripts.n)
		return ts_study_misuse(s, "-sweep needs a script: -in FILE");
	TS_TRY(make_tasks(w));
	TS_TRY(ts_study_open(s, w->task[0].value));
	TS_TRY(ts_study_run_all(s, w->task, w->tasks));
	TS_TRY(ts_study_summary_check_names(s));
	TS_TRY(ts_study_summary_write(s, w->task, w->tasks, w->label, w->groups, text));
	TS_TRY(ts_study_chart(s, w->task, w->tasks, w->label, w->groups, text));
	*failed = ts_study_summary_failures(s, w->task, w->tasks, text);
	ts_str_addf(text, "\n%zu runs, %zu of them now, %zu failed: %s; means: %s/summary.csv\n", w->tasks,
		    s->started, *failed, s->table, s->folder);
	return text->failed ? ts_nomem(&s->sim->error) : TS_OK;
}

int ts_study_sweep(struct tsim *sim, const struct ts_study_input *input)
{
	struct sweep w = { .study = { .sim = sim, .in = input, .option = "-sweep" } };
	struct ts_str text = { 0 };
	size_t failed = 0;
	enum ts_status status = run(&w, &text, &failed);

	if (status == TS_OK)
		ts_log(&sim->log, "%s", ts_str_text(&text));
	ts_str_release(&text);
	return ts_study_end(&w.study, status, failed ? EXIT_FAILURE : EXIT_SUCCESS);
}

void ts_study_help(struct ts_str *out)
{
	ts_str_add(out,
		   "  tsim -sweep 'mu=0.1:0.5:5 seed=1,2,3' -in FILE [-in FILE] [-replicate seed] [-j 2] "
		   "[-var NAME VALUE]\n"
		   "  tsim -calibrate 'E=69 nu=0.26:0.02' -vary 'Ebond=62e9:10e9:200e9 Ec=Ebond' -replicate "
		   "seed=1,2,3 -in FILE\n"
		   "  values: A,B,C; LO:HI:N; LO:HI:N:log; OTHER or OTHER*FACTOR, a variable that stands "
		   "before\n"
		   "  targets: VALUE[:TOLERANCE]; variables of -vary: START[:LO:HI] (a tenth and ten times)\n"
		   "  Results are the lines `RESULT NAME VALUE` and `STUDY NAME=VALUE` that the script "
		   "prints. Each run has a\n"
		   "  folder, which the script gets as the variable out. Runs that are in results/runs.csv "
		   "are not repeated.\n"
		   "  doc/studies.md says more.\n");
}
