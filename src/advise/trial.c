/* A trial runs in a forked copy of the process, as in explain/price.c: it cannot change the state, and all
 * trials start from the same bits. The copy works in a new thread, since OpenMP's threads do not survive a
 * fork. */
#include "advise/trial.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "advise/candidates.h"
#include "base/clock.h"
#include "core/plan.h"
#include "core/report.h"
#include "math/rng.h"
#include "particle/particles.h"
#include "thermo/thermo.h"
#include "wall/wall.h"

#include "base/banned.h"

/* Displacement of the particles in the perturbed trial, in radii. */
static const double ROUND_OFF = 1e-10;

struct copy {
	struct tsim *sim;
	struct ts_trial_results *results;
	struct ts_trial *trial; /* NULL: the probe */
	double seconds;
	struct ts_plan plan;
};

/* Columns without physical meaning: clocks and convergence of solvers. */
static bool is_not_physical(const char *name)
{
	static const char *const names[] = { "step",	"elapsed",    "elaplong", "time",      "dt",
					     "cpu",	"tpcpu",      "spcpu",	  "cpuremain", "timeremain",
					     "cu",	"flow_div",   "flow_cfl", "flow_iter", "flow_res",
					     "flow_dt", "flow_steps", NULL };
	const char *const *n = names;

	while (*n && !ts_streq(*n, name))
		n++;
	return *n != NULL;
}

/* The next argument of a style, from `row` on, that is an interval in steps; NULL at the end. */
static const struct ts_arg *next_interval(const struct ts_arg *row)
{
	for (; row && row->type != TS_ARG_END; row++)
		if ((row->type == TS_ARG_INT && row->help && strstr(row->help, "steps")) ||
		    (row->type == TS_ARG_WORD && ts_streq(row->name, "insert_every")))
			return row;
	return NULL;
}

/* Present value of the interval (steps); 0 if it is 1 or not a number. */
static int64_t present_interval(const struct ts_instance *inst, const struct ts_arg *row)
{
	const void *field = (const char *)inst->state + row->offset;
	const char *text = row->type == TS_ARG_WORD ? *(const char *const *)field : NULL;
	int64_t n = 0;

	if (row->type == TS_ARG_INT)
		n = *(const int64_t *)field;
	else if (!text || !ts_parse_int(text, &n))
		n = 0;
	return n > 1 ? n : 0; /* an action in each step remains one in each step */
}

/* Averages over a number of steps are averages over another time if dt differs, and fixes
 * check/timestep/... measure dt itself. */
static bool depends_on_steps(const struct ts_ref *ref)
{
	return ref->kind == TS_REF_FIX && ref->inst &&
	       (next_interval(ref->inst->style->args) ||
		ts_streq(ref->inst->style->name, "check/timestep/gran") ||
		ts_streq(ref->inst->style->name, "check/timestep/bond"));
}

static bool acts_in_step(const struct ts_instance *inst)
{
	for (int stage = TS_STAGE_INITIAL_INTEGRATE; stage <= TS_STAGE_FINAL_INTEGRATE; stage++)
		if (inst->style->hook[stage])
			return true;
	return false;
}

/* Lists the fixes that act at intervals in steps. */
static void list_interval_fixes(const struct tsim *sim, struct ts_trial_results *results)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	size_t n = 0, room = sizeof results->interval_fixes;

	for (size_t k = 0; k < fixes->n; k++) {
		const struct ts_instance *fix = fixes->item[k];
		const struct ts_arg *row = acts_in_step(fix) ? next_interval(fix->style->args) : NULL;

		for (; row && n + 1 < room; row = next_interval(row + 1))
			if (present_interval(fix, row))
				n += (size_t)snprintf(results->interval_fixes + n, room - n, "%s%s %s",
						      n ? ", " : "", fix->id, row->name);
	}
}

/* Scales the number of steps until the next event, which is part of the saved state. */
static void scale_waiting_steps(struct ts_instance *fix, double factor)
{
	for (const struct ts_saved *row = fix->style->saved; row && row->type != TS_SAVED_END; row++) {
		int64_t *wait = (int64_t *)(void *)((char *)fix->state + row->offset);

		if (row->type == TS_SAVED_I64 && ts_ends_with(row->name, "wait") && *wait > 1)
			*wait = llround(fmax(1, (double)*wait * factor));
	}
}

/* Scales intervals in steps so that with another dt fixes act at the same times. */
static enum ts_status scale_intervals(struct tsim *sim, double factor)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++) {
		struct ts_instance *fix = fixes->item[k];
		const struct ts_arg *row = acts_in_step(fix) ? next_interval(fix->style->args) : NULL;

		if (row)
			scale_waiting_steps(fix, factor);
		for (; row; row = next_interval(row + 1)) {
			void *field = (char *)fix->state + row->offset;
			int64_t n = llround((double)present_interval(fix, row) * factor);
			char text[32];

			if (n < 1)
				continue;
			snprintf(text, sizeof text, "%" PRId64, n);
			if (row->type == TS_ARG_INT)
				*(int64_t *)field = n;
			else if (!(*(const char **)field = ts_pool_get(sim->pool, text)))
				return ts_nomem(&sim->error);
		}
	}
	return TS_OK;
}

static int list_titles(struct tsim *sim, struct ts_trial_results *results)
{
	const struct ts_thermo *t = sim->thermo;
	int n = 0;

	for (size_t k = 0; k < t->n && n < TS_TRIAL_COLUMNS; k++)
		if (!is_not_physical(t->column[k].input.name)) {
			results->step_dependent[n] = depends_on_steps(&t->column[k].input.ref);
			snprintf(results->title[n], sizeof results->title[0], "%s%s",
				 results->step_dependent[n] ? "#" : "", t->column[k].title);
			n++;
		}
	return n;
}

/* Evaluates the columns; NaN for one that cannot be evaluated now. */
static void sample_columns(struct tsim *sim, double *out)
{
	const struct ts_thermo *t = sim->thermo;
	int n = 0;

	for (size_t k = 0; k < t->n && n < TS_TRIAL_COLUMNS; k++) {
		if (is_not_physical(t->column[k].input.name))
			continue;
		if (ts_ref_input_scalar(sim, &t->column[k].input, &out[n]) != TS_OK)
			out[n] = NAN;
		ts_error_clear(&sim->error);
		n++;
	}
}

static void move_by_round_off(struct tsim *sim)
{
	struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++) {
		struct ts_rng rng = ts_rng_start(1, (uint64_t)p->tag[i]);

		for (int d = 0; d < sim->dimension; d++)
			p->x[i][d] += ROUND_OFF * p->radius[i] * (2 * ts_rng_uniform(&rng) - 1);
	}
}

/* Ramps over a run keep their rate of change in time. */
static void scale_ramp(struct ts_clock *c, double dt_before, double dt)
{
	double length = (double)(c->ramp_last - c->ramp_first) * dt_before / dt;
	double done = (double)(c->step - c->ramp_first) * dt_before / dt;

	c->ramp_first = c->step - (int64_t)llround(done);
	c->ramp_last = c->ramp_first + (int64_t)llround(length);
}

/* Wall time with several threads; processor time with one, independent of other load on the machine (s). */
static double trial_clock(const struct tsim *sim)
{
	struct timespec now;

	if (sim->threads > 1)
		return ts_clock();
	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Number of touching contacts, of pairs and of particles with walls. */
static double count_contacts(const struct tsim *sim)
{
	const struct ts_contact_list *rows = &sim->neigh->contacts;
	const struct ts_wall *w;
	double n = 0;

	for (size_t r = 0; r < rows->n; r++)
		n += ts_contact_touches(rows, r);
	for (size_t k = 0; (w = ts_walls_next(sim, &k, NULL));)
		for (size_t m = 0; m < w->contacts.n; m++)
			n += w->contacts.touching[m] != 0;
	return n;
}

static enum ts_status start_run(struct copy *c, int64_t steps)
{
	struct ts_clock *clock = &c->sim->clock;

	clock->first_step = clock->step;
	clock->last_step = clock->goal = clock->step + steps;
	/* all trials compute the forces anew, not only those that change a setting */
	c->sim->run.fingerprint = 0;
	c->sim->run.in_pieces = true; /* no thermo output at the end of each piece */
	c->sim->run.unsafe = false;
	TS_TRY(ts_plan_compile(&c->plan, c->sim));
	return ts_plan_start(&c->plan, c->sim, true);
}

static enum ts_status run_steps(struct copy *c, int64_t steps, double *seconds)
{
	double begin = trial_clock(c->sim);

	c->sim->clock.last_step = c->sim->clock.step + steps;
	TS_TRY(ts_plan_steps(&c->plan, c->sim));
	*seconds += trial_clock(c->sim) - begin;
	return TS_OK;
}

/* The largest time step that a run accepts. */
static enum ts_status find_step_limit(struct tsim *sim, double *out)
{
	struct ts_plan_report report = { .limits_only = true };
	enum ts_status status = ts_report_collect(&report, sim);
	const struct ts_limit *limit = ts_report_binding(&report, true);

	*out = limit ? limit->dt : INFINITY;
	ts_report_release(&report);
	return status;
}

static enum ts_status measure_step(struct copy *c)
{
	struct ts_trial_results *b = c->results;
	int64_t n = 1, steps = 0;
	double begin, ignored = 0; /* `begin`: wall time, which is limited */

	TS_TRY(start_run(c, b->steps_left));
	b->columns = list_titles(c->sim, b);
	list_interval_fixes(c->sim, b);
	TS_TRY(find_step_limit(c->sim, &b->limit));
	begin = ts_clock();
	TS_TRY(run_steps(c, 1, &ignored)); /* with cold caches: used only if there is no time for more */
	b->step_seconds = ts_clock() - begin;
	for (begin = ts_clock(); ts_clock() - begin < c->seconds && steps + 1 < b->steps_left; n *= 2) {
		n = n > b->steps_left - steps - 1 ? b->steps_left - steps - 1 : n;
		TS_TRY(run_steps(c, n, &ignored));
		steps += n;
		b->step_seconds = (ts_clock() - begin) / (double)steps;
	}
	return TS_OK;
}

/* Integrates over the physical time of the trial, in equal parts between samples; dt is adjusted to divide a
 * part. */
static enum ts_status integrate_trial(struct copy *c)
{
	struct ts_trial *t = c->trial;
	struct ts_trial_results *b = c->results;
	int samples = b->steps < TS_TRIAL_SAMPLES ? (int)b->steps : TS_TRIAL_SAMPLES;
	double part = (double)(b->steps / samples) * b->dt;
	int64_t n = b->steps / samples;

	if (t->dt > 0 && t->dt != b->dt) {
		n = (int64_t)ceil(part / t->dt - 1e-9);
		ts_sim_set_dt(c->sim, part / (double)n);
		scale_ramp(&c->sim->clock, b->dt, c->sim->clock.dt);
		TS_TRY(scale_intervals(c->sim, b->dt / c->sim->clock.dt));
	}
	if (t->subject == TS_SUBJECT_PERTURBED)
		move_by_round_off(c->sim);
	TS_TRY(start_run(c, n * samples));
	sample_columns(c->sim, t->column[0]);
	for (int k = 1; k <= samples; k++) {
		TS_TRY(run_steps(c, n, &t->seconds));
		if (c->sim->run.halted) {
			snprintf(t->failure, sizeof t->failure, "stopped after %.3g s", c->seconds);
			return TS_OK;
		}
		sample_columns(c->sim, t->column[k]);
		t->contacts = fmax(t->contacts, count_contacts(c->sim));
	}
	t->samples = samples;
	t->steps = n * samples;
	t->done = true;
	return TS_OK;
}

static enum ts_status run_setting(struct copy *c)
{
	c->sim->run.halted = false;
	c->sim->run.timeout = ts_clock() + c->seconds;
	c->sim->run.timeout_every = 1;
	if (!c->trial) {
		c->sim->run.timeout = 0;
		return measure_step(c);
	}
	TS_TRY(ts_candidates_apply(c->sim, c->results, c->trial));
	return integrate_trial(c);
}

static void *copy_thread(void *data)
{
	struct copy *c = data;

	if (run_setting(c) != TS_OK) {
		char *trouble = c->trial ? c->trial->failure : c->results->failure;

		snprintf(trouble, sizeof c->trial->failure, "%.280s", c->sim->error.message);
	}
	return NULL;
}

/* Does not return. */
static void run_as_copy(struct copy *c)
{
	pthread_t thread;

	if (pthread_create(&thread, NULL, copy_thread, c) == 0)
		pthread_join(thread, NULL);
	_exit(0);
}

static void fork_copy(struct copy *c, char *trouble, size_t room)
{
	pid_t child;
	int status = 0;

	fflush(NULL); /* otherwise the copy would write the buffered output again */
	child = fork();
	if (child == 0)
		run_as_copy(c);
	if (child < 0) {
		snprintf(trouble, room, "cannot start a process: %s", strerror(errno));
		return;
	}
	while (waitpid(child, &status, 0) < 0 && errno == EINTR)
		continue;
	if (WIFSIGNALED(status))
		snprintf(trouble, room, "terminated by signal %d", WTERMSIG(status));
}

void ts_trial_probe(struct tsim *sim, struct ts_trial_results *results, double seconds)
{
	struct copy c = { .sim = sim, .results = results, .seconds = seconds };

	fork_copy(&c, results->failure, sizeof results->failure);
}

void ts_trial_repeat(struct tsim *sim, struct ts_trial_results *results, int k, double seconds)
{
	struct ts_trial *t = &results->trial[k];
	struct copy c = { .sim = sim, .results = results, .trial = t, .seconds = seconds };
	double least = t->seconds;

	bool before = t->done;

	t->seconds = 0;
	t->done = false;
	fork_copy(&c, t->failure, sizeof t->failure);
	if (!t->done && before) { /* the time was used up: the previous measurement is kept */
		t->done = true;
		t->seconds = least;
		return;
	}
	t->longest = fmax(t->longest, t->seconds);
	t->seconds = fmin(least, t->seconds);
}

void ts_trial_run(struct tsim *sim, struct ts_trial_results *results, int k, double seconds)
{
	struct ts_trial *t = &results->trial[k];

	t->seconds = INFINITY;
	for (int r = 0; r < results->repeats && (!r || t->done); r++)
		ts_trial_repeat(sim, results, k, seconds);
}
