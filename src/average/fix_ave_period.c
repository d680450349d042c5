/* Fix ave/period: frequency of a signal, and averages over its whole periods. */
#include "core/ref_list.h"
#include "core/sim.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/banned.h"

/* Time integrals of one value over the current, incomplete period (open) and over all completed ones (whole).
 * What is integrated is the difference from the first sample, so that small oscillations about a large mean
 * keep their digits. */
struct tally {
	double first, last;	      /* first and latest sample */
	double open[2];		      /* integrals of the difference and of its square */
	double whole[2];	      /* the same, of completed periods */
	double open_least, open_most; /* extreme samples of the current period */
	double least, most;	      /* and of completed ones */
};
enum { TALLY = sizeof(struct tally) / sizeof(double) };

struct state {
	int64_t every, start;
	struct ts_words words;
	double level;
	struct ts_ref_list input;
	double *now;	     /* [n] the current sample */
	struct tally *tally; /* [n] of each value; the first value is the signal */
	size_t capacity, n;
	/* state, written to restart files with the tallies */
	int64_t periods;    /* completed */
	int64_t seen, step; /* 1: there is a sample; step of the latest one */
	double time;	    /* of the latest sample */
	double begin, end;  /* time of the first and the latest upward crossing; NaN: none */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_ref_list_init(sim, "fix ave/period", &self->arena, s->words, TS_WANT(SCALAR), &s->input));
	if (!s->now)
		s->now = ts_arena_alloc(&self->arena, s->input.n, sizeof *s->now);
	if (!s->now || TS_GROW(s->tally, s->capacity, s->input.n) != TS_OK)
		return ts_nomem(&sim->error);
	s->n = s->input.n;
	return TS_OK;
}

/* Adds the integrals over a time dt in which the value goes linearly from a to b. */
static void integrate_segment(struct tally *t, double a, double b, double dt)
{
	a -= t->first;
	b -= t->first;
	t->open[0] += 0.5 * (a + b) * dt;
	t->open[1] += (a * a + a * b + b * b) / 3 * dt;
}

/* The signal rises through the level: the current period is complete, unless this is the first crossing. */
static void close_period(struct state *s, double time)
{
	bool first = isnan(s->begin);

	for (size_t k = 0; k < s->n; k++) {
		struct tally *t = &s->tally[k];

		for (int m = 0; m < 2; m++) {
			t->whole[m] += first ? 0 : t->open[m];
			t->open[m] = 0;
		}
		if (!first) {
			t->least = fmin(t->least, t->open_least);
			t->most = fmax(t->most, t->open_most);
		}
		t->open_least = INFINITY;
		t->open_most = -INFINITY;
	}
	s->periods += !first;
	s->begin = first ? time : s->begin;
	s->end = time;
}

static void add_sample(struct state *s, double time)
{
	double was = s->tally[0].last, is = s->now[0], dt = time - s->time, part = 1;
	bool crosses = was < s->level && is >= s->level;

	if (crosses)
		part = (s->level - was) / (is - was);
	for (size_t k = 0; k < s->n; k++) {
		struct tally *t = &s->tally[k];

		integrate_segment(t, t->last, t->last + part * (s->now[k] - t->last), part * dt);
	}
	if (crosses)
		close_period(s, s->time + part * dt);
	for (size_t k = 0; k < s->n; k++) {
		struct tally *t = &s->tally[k];

		if (crosses)
			integrate_segment(t, t->last + part * (s->now[k] - t->last), s->now[k],
					  (1 - part) * dt);
		t->open_least = fmin(t->open_least, s->now[k]);
		t->open_most = fmax(t->open_most, s->now[k]);
		t->last = s->now[k];
	}
}

static void begin_tallies(struct state *s)
{
	s->begin = s->end = NAN;
	for (size_t k = 0; k < s->n; k++)
		s->tally[k] = (struct tally){ .first = s->now[k],
					      .last = s->now[k],
					      .open_least = s->now[k],
					      .open_most = s->now[k],
					      .least = INFINITY,
					      .most = -INFINITY };
	s->seen = 1;
}

static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return sim->clock.step % s->every == 0 && sim->clock.step >= s->start;
}

static enum ts_status sample(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	int64_t step = sim->clock.step;
	double time = ts_sim_time(sim);

	if (!due(self, sim) || (s->seen && step == s->step))
		return TS_OK;
	TS_TRY(ts_ref_list_scalars(sim, &s->input, s->now));
	if (s->seen)
		add_sample(s, time);
	else
		begin_tallies(s);
	s->time = time;
	s->step = step;
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive)
{
	struct state *s = self->state;
	size_t n = s->n * TALLY, capacity = n;
	double *data = ts_alloc(n, sizeof *data);
	enum ts_status status;

	if (!data)
		return ts_nomem(&sim->error);
	memcpy(data, s->tally, n * sizeof *data);
	status = ts_archive_array(archive, "tally", TS_SAVED_F64, (void **)&data, &capacity, &n);
	if (status == TS_OK && n != s->n * TALLY)
		status =
			ts_fail(&sim->error, TS_STATE, &self->where,
				"fix ave/period %s: the restart file has another number of values", self->id);
	else if (status == TS_OK)
		memcpy(s->tally, data, n * sizeof *data);
	ts_free(data);
	return status;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_free(s->tally);
	ts_ref_list_release(&s->input);
}

/* ---- outputs */

static enum ts_status eval_signal(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	out->data[0] = s->periods ? (double)s->periods / (s->end - s->begin) : 0;
	out->data[1] = (double)s->periods;
	return TS_OK;
}

static enum ts_status eval_values(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	TS_TRY(ts_table_resize(out, s->n, 4));
	for (size_t k = 0; k < s->n; k++) {
		const struct tally *t = &s->tally[k];
		double length = s->end - s->begin, *row = out->data + 4 * k;
		double mean = t->whole[0] / length;

		memset(row, 0, 4 * sizeof *row);
		if (!s->periods)
			continue;
		row[0] = t->first + mean;
		row[1] = t->least;
		row[2] = t->most;
		row[3] = sqrt(fmax(0, t->whole[1] / length - mean * mean));
	}
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_INT("every", struct state, every, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_POSITIVE,
	       .help = "steps between samples"),
	TS_LIST_STATEFUL("values", struct state, words,
			 .help = "the signal, then more values to be averaged: c_ID, c_ID[k], f_ID, f_ID[k], "
				 "v_NAME or thermo keywords"),
	TS_REAL("level", struct state, level, .flags = TS_STATEFUL, .fallback = "0",
		.help = "a period begins where the signal rises through this value"),
	TS_INT("start", struct state, start, .flags = TS_STATEFUL, .fallback = "0",
	       .help = "no samples before this step"),
	TS_ARGS_END,
};

static const char *const columns[] = { "mean", "min", "max", "rms", NULL };
static const struct ts_value values[] = {
	{ .name = "signal",
	  .unit = "",
	  .help = "[1] frequency in periods per unit of time, [2] number of completed periods",
	  .shape = TS_VECTOR,
	  .columns = 2,
	  .eval = eval_signal },
	{ .name = "values",
	  .unit = "",
	  .help = "for each value over these periods: [1] mean, [2] smallest and [3] largest sample, [4] "
		  "standard deviation",
	  .shape = TS_ARRAY,
	  .columns = 4,
	  .column_names = columns,
	  .eval = eval_values },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct state, periods),
	TS_SAVE_I64(struct state, seen),
	TS_SAVE_I64(struct state, step),
	TS_SAVE_F64(struct state, time),
	TS_SAVE_F64(struct state, begin),
	TS_SAVE_F64(struct state, end),
	TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_ave_period)
const struct ts_style ts_fix_ave_period = {
	.name = "ave/period",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = due,
	.summary = "Frequency of a signal, and averages of values over its completed periods",
	.doc = "Determines the frequency of the first value, the signal, and averages all values over whole "
	       "periods of it. Samples are taken at the start of a run and at the end of each step that is a "
	       "multiple of N. A period begins where the signal rises through `level`; between samples all "
	       "values are interpolated linearly. f_ID[1] is the number of completed periods divided by the "
	       "time from the first to the last of these crossings, f_ID[2] that number; f_ID[i][1] ... "
	       "f_ID[i][4] are the mean, the smallest and largest sample, and the rms deviation from the "
	       "mean of value i over this time. All are 0 before the first period is complete.",
	.example = "fix ib all immersed/boundary region rod\n"
		   "fix wake all ave/period 1 f_ib[2] f_ib[1] start 20000\n"
		   "variable St equal f_wake[1]*1.0/2.0",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_SETUP] = sample, [TS_STAGE_END_OF_STEP] = sample },
	.fini = fini,
};
