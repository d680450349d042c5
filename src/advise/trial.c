/* A trial runs in a copy of the process (fork), as explain/price.c does it: nothing it does can touch the
 * scene, and all trials start from the same bits. The copy works in a new thread, since OpenMP's do not
 * survive a fork. */
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

/* How far a twin's particles are moved, in radii. */
static const double ROUND_OFF = 1e-10;

struct copy {
	struct tsim *sim;
	struct ts_board *board;
	struct ts_trial *trial; /* NULL: the probe */
	double seconds;
	struct ts_plan plan;
};

/* Columns that say nothing about the physics: clocks, and how well a solver does. */
static bool tells_nothing(const char *name)
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

/* The next argument of a style that is an interval in steps; NULL: there are no more. */
static const struct ts_arg *next_interval(const struct ts_arg *row)
{
	for (; row && row->type != TS_ARG_END; row++)
		if ((row->type == TS_ARG_INT && row->help && strstr(row->help, "steps")) ||
		    (row->type == TS_ARG_WORD && ts_streq(row->name, "insert_every")))
			return row;
	return NULL;
}

/* What it is now; 0: none, or no number. */
static int64_t interval_now(const struct ts_instance *inst, const struct ts_arg *row)
{
	const void *field = (const char *)inst->state + row->offset;
	const char *text = row->type == TS_ARG_WORD ? *(const char *const *)field : NULL;
	int64_t n = 0;

	if (row->type == TS_ARG_INT)
		n = *(const int64_t *)field;
	else if (!text || !ts_parse_int(text, &n))
		n = 0;
	return n > 1 ? n : 0; /* each step stays each step */
}

/* Averages over some number of steps are of another time with another step; and one fix measures the step. */
static bool counts_steps(const struct ts_ref *ref)
{
	return ref->kind == TS_REF_FIX && ref->inst &&
	       (next_interval(ref->inst->style->args) ||
		ts_streq(ref->inst->style->name, "check/timestep/gran"));
}

static bool acts(const struct ts_instance *inst)
{
	for (int stage = TS_STAGE_INITIAL_INTEGRATE; stage <= TS_STAGE_FINAL_INTEGRATE; stage++)
		if (inst->style->hook[stage])
			return true;
	return false;
}

/* Fixes that act every so many steps. */
static void note_counters(const struct tsim *sim, struct ts_board *board)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	size_t n = 0, room = sizeof board->counters;

	for (size_t k = 0; k < fixes->n; k++) {
		const struct ts_instance *fix = fixes->item[k];
		const struct ts_arg *row = acts(fix) ? next_interval(fix->style->args) : NULL;

		for (; row && n + 1 < room; row = next_interval(row + 1))
			if (interval_now(fix, row))
				n += (size_t)snprintf(board->counters + n, room - n, "%s%s %s", n ? ", " : "",
						      fix->id, row->name);
	}
}

/* Steps until the next event, which is saved state. */
static void stretch_waiting(struct ts_instance *fix, double factor)
{
	for (const struct ts_saved *row = fix->style->saved; row && row->type != TS_SAVED_END; row++) {
		int64_t *wait = (int64_t *)(void *)((char *)fix->state + row->offset);

		if (row->type == TS_SAVED_I64 && ts_ends_with(row->name, "wait") && *wait > 1)
			*wait = llround(fmax(1, (double)*wait * factor));
	}
}

/* With another step they act at the same times, as the user would write it. */
static enum ts_status stretch_intervals(struct tsim *sim, double factor)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++) {
		struct ts_instance *fix = fixes->item[k];
		const struct ts_arg *row = acts(fix) ? next_interval(fix->style->args) : NULL;

		if (row)
			stretch_waiting(fix, factor);
		for (; row; row = next_interval(row + 1)) {
			void *field = (char *)fix->state + row->offset;
			int64_t n = llround((double)interval_now(fix, row) * factor);
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

static int list_titles(struct tsim *sim, struct ts_board *board)
{
	const struct ts_thermo *t = sim->thermo;
	int n = 0;

	for (size_t k = 0; k < t->n && n < TS_TRIAL_COLUMNS; k++)
		if (!tells_nothing(t->column[k].input.name)) {
			board->counts[n] = counts_steps(&t->column[k].input.ref);
			snprintf(board->title[n], sizeof board->title[0], "%s%s", board->counts[n] ? "#" : "",
				 t->column[k].title);
			n++;
		}
	return n;
}

/* A column that cannot be read now is NaN. */
static void look(struct tsim *sim, double *out)
{
	const struct ts_thermo *t = sim->thermo;
	int n = 0;

	for (size_t k = 0; k < t->n && n < TS_TRIAL_COLUMNS; k++) {
		if (tells_nothing(t->column[k].input.name))
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

/* What changes over a run goes on changing at the same speed. */
static void stretch_ramp(struct ts_clock *c, double dt_before, double dt)
{
	double length = (double)(c->ramp_last - c->ramp_first) * dt_before / dt;
	double done = (double)(c->step - c->ramp_first) * dt_before / dt;

	c->ramp_first = c->step - (int64_t)llround(done);
	c->ramp_last = c->ramp_first + (int64_t)llround(length);
}

/* Threads share the wall time; one thread has its own, whatever else the machine does. */
static double stop_watch(const struct tsim *sim)
{
	struct timespec now;

	if (sim->threads > 1)
		return ts_clock();
	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Contacts that touch now, of particles and with walls. */
static double touching(const struct tsim *sim)
{
	const struct ts_contact_list *rows = &sim->neigh->contacts;
	const struct ts_wall *w;
	double n = 0;

	for (size_t r = 0; r < rows->n; r++)
		n += rows->touching[r] != 0;
	for (size_t k = 0; (w = ts_walls_next(sim, &k, NULL));)
		for (size_t m = 0; m < w->contacts.n; m++)
			n += w->contacts.touching[m] != 0;
	return n;
}

static enum ts_status start(struct copy *c, int64_t steps)
{
	struct ts_clock *clock = &c->sim->clock;

	clock->first_step = clock->step;
	clock->last_step = clock->goal = clock->step + steps;
	c->sim->run.fingerprint =
		0; /* all trials compute forces anew, not only those that change something */
	c->sim->run.in_pieces = true; /* no row of the table at the end of each piece */
	c->sim->run.unsafe = false;
	TS_TRY(ts_plan_compile(&c->plan, c->sim));
	return ts_plan_start(&c->plan, c->sim, true);
}

static enum ts_status go(struct copy *c, int64_t steps, double *seconds)
{
	double begin = stop_watch(c->sim);

	c->sim->clock.last_step = c->sim->clock.step + steps;
	TS_TRY(ts_plan_steps(&c->plan, c->sim));
	*seconds += stop_watch(c->sim) - begin;
	return TS_OK;
}

/* The least step beyond which a run is refused. */
static enum ts_status find_limit(struct tsim *sim, double *out)
{
	struct ts_plan_report report = { .limits_only = true };
	enum ts_status status = ts_report_collect(&report, sim);
	const struct ts_limit *limit = ts_report_binding(&report, true);

	*out = limit ? limit->dt : INFINITY;
	ts_report_release(&report);
	return status;
}

static enum ts_status probe(struct copy *c)
{
	struct ts_board *b = c->board;
	int64_t n = 1, steps = 0;
	double begin, ignored = 0; /* wall time, which is what may be spent */

	TS_TRY(start(c, b->left));
	b->columns = list_titles(c->sim, b);
	note_counters(c->sim, b);
	TS_TRY(find_limit(c->sim, &b->limit));
	begin = ts_clock();
	TS_TRY(go(c, 1, &ignored)); /* finds cold memory: it counts only if there is time for no other */
	b->step_seconds = ts_clock() - begin;
	for (begin = ts_clock(); ts_clock() - begin < c->seconds && steps + 1 < b->left; n *= 2) {
		n = n > b->left - steps - 1 ? b->left - steps - 1 : n;
		TS_TRY(go(c, n, &ignored));
		steps += n;
		b->step_seconds = (ts_clock() - begin) / (double)steps;
	}
	return TS_OK;
}

/* The same physical time for all trials, cut into equal parts; a step that fits. */
static enum ts_status follow(struct copy *c)
{
	struct ts_trial *t = c->trial;
	struct ts_board *b = c->board;
	int looks = b->steps < TS_TRIAL_LOOKS ? (int)b->steps : TS_TRIAL_LOOKS;
	double part = (double)(b->steps / looks) * b->dt;
	int64_t n = b->steps / looks;

	if (t->dt > 0 && t->dt != b->dt) {
		n = (int64_t)ceil(part / t->dt - 1e-9);
		ts_sim_set_dt(c->sim, part / (double)n);
		stretch_ramp(&c->sim->clock, b->dt, c->sim->clock.dt);
		TS_TRY(stretch_intervals(c->sim, b->dt / c->sim->clock.dt));
	}
	if (t->subject == TS_SUBJECT_TWIN)
		move_by_round_off(c->sim);
	TS_TRY(start(c, n * looks));
	look(c->sim, t->column[0]);
	for (int k = 1; k <= looks; k++) {
		TS_TRY(go(c, n, &t->seconds));
		if (c->sim->run.halted) {
			snprintf(t->trouble, sizeof t->trouble, "given up after %.3g s", c->seconds);
			return TS_OK;
		}
		look(c->sim, t->column[k]);
		t->contacts = fmax(t->contacts, touching(c->sim));
	}
	t->looks = looks;
	t->steps = n * looks;
	t->done = true;
	return TS_OK;
}

static enum ts_status attempt(struct copy *c)
{
	c->sim->run.halted = false;
	c->sim->run.timeout = ts_clock() + c->seconds;
	c->sim->run.timeout_every = 1;
	if (!c->trial) {
		c->sim->run.timeout = 0;
		return probe(c);
	}
	TS_TRY(ts_candidates_apply(c->sim, c->board, c->trial));
	return follow(c);
}

static void *in_copy(void *data)
{
	struct copy *c = data;

	if (attempt(c) != TS_OK) {
		char *trouble = c->trial ? c->trial->trouble : c->board->trouble;

		snprintf(trouble, sizeof c->trial->trouble, "%.280s", c->sim->error.message);
	}
	return NULL;
}

/* Never comes back. */
static void be_copy(struct copy *c)
{
	pthread_t thread;

	if (pthread_create(&thread, NULL, in_copy, c) == 0)
		pthread_join(thread, NULL);
	_exit(0);
}

static void run_copy(struct copy *c, char *trouble, size_t room)
{
	pid_t child;
	int status = 0;

	fflush(NULL); /* or the copy would write what waits, too */
	child = fork();
	if (child == 0)
		be_copy(c);
	if (child < 0) {
		snprintf(trouble, room, "cannot start a process: %s", strerror(errno));
		return;
	}
	while (waitpid(child, &status, 0) < 0 && errno == EINTR)
		continue;
	if (WIFSIGNALED(status))
		snprintf(trouble, room, "ended by signal %d", WTERMSIG(status));
}

void ts_trial_probe(struct tsim *sim, struct ts_board *board, double seconds)
{
	struct copy c = { .sim = sim, .board = board, .seconds = seconds };

	run_copy(&c, board->trouble, sizeof board->trouble);
}

void ts_trial_repeat(struct tsim *sim, struct ts_board *board, int k, double seconds)
{
	struct ts_trial *t = &board->trial[k];
	struct copy c = { .sim = sim, .board = board, .trial = t, .seconds = seconds };
	double least = t->seconds;

	bool before = t->done;

	t->seconds = 0;
	t->done = false;
	run_copy(&c, t->trouble, sizeof t->trouble);
	if (!t->done && before) { /* the time was over: what was measured before counts */
		t->done = true;
		t->seconds = least;
		return;
	}
	t->longest = fmax(t->longest, t->seconds);
	t->seconds = fmin(least, t->seconds);
}

void ts_trial_run(struct tsim *sim, struct ts_board *board, int k, double seconds)
{
	struct ts_trial *t = &board->trial[k];

	t->seconds = INFINITY;
	for (int r = 0; r < board->repeats && (!r || t->done); r++)
		ts_trial_repeat(sim, board, k, seconds);
}
