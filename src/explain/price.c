/* The trial runs in a forked copy of the process, so that it cannot change particles, styles, random
 * streams or files of the simulation. Threads do not survive a fork, and OpenMP has a team for each thread
 * that uses it: the copy runs in a new thread, which starts a new team. */
#include "explain/price.h"

#include <errno.h>
#include <math.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/clock.h"

#include "base/banned.h"

static const double TRIAL = 0.3;  /* seconds of trial for one run */
static const double TRIALS = 2;	  /* seconds for all runs of a script */
static const double CROWD = 0.15; /* seconds for the steps with a dense packing */
static const double PART = 0.05;  /* seconds for the steps with an omitted part */
static const double STILL =
	1e-6; /* factor of the time step in a dense packing, so that particles hardly move */
/* seconds after which a trial is killed: the first ones, and each one when all have taken that long together */
static const double LONGEST = 20, LONGEST_LATER = 1;

enum { LONGEST_REASON = 200 }; /* characters of an error */

struct trial {
	struct ts_plan *plan;
	struct tsim *sim;
	double budget; /* seconds */
	unsigned full; /* omitted parts to include (enum ts_full); only the time of a step is measured */
	int64_t steps; /* of the run */
	int to;	       /* end of the pipe to the parent process */
	struct ts_price price;
};

/* Seconds of each action of the first output: the time of each dump for a frame. */
static enum ts_status time_frames(struct trial *t, double *seconds)
{
	const struct ts_plan *plan = t->plan;

	for (size_t k = 0; k < plan->n[TS_STAGE_OUTPUT]; k++) {
		const struct ts_action *action = &plan->actions[TS_STAGE_OUTPUT][k];
		double start = ts_clock();

		TS_TRY(action->hook(action->self, t->sim));
		seconds[k] = ts_clock() - start;
	}
	return TS_OK;
}

/* Adds the time of frames whose interval is longer than the trial. */
static void add_rare_frames(struct trial *t, const double *seconds)
{
	const struct ts_plan *plan = t->plan;

	for (size_t k = 0; k < plan->n[TS_STAGE_OUTPUT]; k++) {
		const struct ts_instance *dump = plan->actions[TS_STAGE_OUTPUT][k].self;

		if (dump->style->kind == TS_KIND_DUMP && dump->every > t->price.steps)
			t->price.frames += seconds[k] * (double)(t->steps / dump->every);
	}
}

/* Runs steps for `budget` seconds. *seconds: mean time of a step without the first one, whose data are not in the cache and
 * whose pages the copy of the process gets, unless the run has one only. */
static enum ts_status time_steps(struct trial *t, double budget, double *seconds, int64_t *steps)
{
	double start = ts_clock(), first = start;

	TS_TRY(ts_plan_step(t->plan, t->sim));
	*seconds = ts_clock() - first;
	*steps = 1;
	first = ts_clock();
	while (*steps < t->steps && (*steps == 1 || ts_clock() - start < budget)) {
		TS_TRY(ts_plan_step(t->plan, t->sim));
		*seconds = (ts_clock() - first) / (double)(*steps)++;
	}
	ts_deferred_loops_run(t->sim);
	return TS_OK;
}

/* Times steps of a dense packing. The particles hardly move, so that rebuilds of the neighbor list are
 * added at the rate of the first trial. */
static enum ts_status time_dense_packing(struct trial *t)
{
	const struct ts_instances *systems = &t->sim->instances[TS_KIND_SYSTEM];
	double often = (double)t->plan->rebuilds / (double)t->price.steps, start, seconds;
	int64_t steps;

	for (size_t k = 0; k < systems->n; k++) {
		const struct ts_system_style *style = (const struct ts_system_style *)systems->item[k]->style;

		if (style->crowd)
			TS_TRY(style->crowd(systems->item[k], t->sim));
	}
	t->sim->clock.dt *= STILL;
	start = ts_clock();
	TS_TRY(ts_plan_stages(t->plan, t->sim, TS_STAGE_PRE_EXCHANGE, TS_STAGE_POST_BUILD));
	often *= ts_clock() - start;
	TS_TRY(ts_plan_stages(t->plan, t->sim, TS_STAGE_PRE_FORCE, TS_STAGE_FINAL_INTEGRATE));
	TS_TRY(time_steps(t, CROWD, &seconds, &steps));
	t->price.crowded = fmax(t->price.seconds, seconds + often);
	return TS_OK;
}

static enum ts_status time_run(struct trial *t, double *frames)
{
	struct ts_price *price = &t->price;

	TS_TRY(ts_plan_first_forces(t->plan, t->sim, true));
	TS_TRY(time_frames(t, frames));
	TS_TRY(time_steps(t, t->budget, &price->seconds, &price->steps));
	price->crowded = price->seconds;
	add_rare_frames(t, frames);
	return TS_OK;
}

/* Includes omitted parts in the plan of the copy. */
static enum ts_status include_omitted(struct trial *t)
{
	struct tsim *sim = t->sim;

	if (!t->full)
		return TS_OK;
	sim->full |= t->full;
	if (t->full & TS_FULL_THREADS)
		sim->grain = 1;
	TS_TRY(ts_plan_compile(t->plan, sim));
	return ts_plan_stages(t->plan, sim, TS_STAGE_BUILD, TS_STAGE_POST_BUILD);
}

static void *run_trial(void *data)
{
	struct trial *t = data;
	struct ts_price price;
	double *frames = ts_alloc(t->plan->n[TS_STAGE_OUTPUT] + 1, sizeof *frames);

	t->sim->reading.planned = false; /* values are needed here */
	t->sim->log.quiet = t->sim->log.withholds = true;
	t->sim->log.progress = false;
	if (!frames || include_omitted(t) != TS_OK || time_run(t, frames) != TS_OK) {
		t->price = (struct ts_price){ .seconds = NAN };
		snprintf(t->price.why, sizeof t->price.why, "the first steps failed: %.*s", LONGEST_REASON,
			 t->sim->error.message);
	} else if (!t->full) {
		time_dense_packing(t); /* if it fails, the price has the first time only */
	}
	price = t->price;
	if (write(t->to, &price, sizeof price) < 0)
		t->price.steps = 0;
	ts_free(frames);
	return NULL;
}

/* The child process; does not return. */
static void run_child(struct trial *t)
{
	pthread_t thread;

	signal(SIGINT, SIG_DFL);
	signal(SIGTERM, SIG_DFL);
	if (t->sim->threads == 1)
		run_trial(t);
	else if (pthread_create(&thread, NULL, run_trial, t) == 0)
		pthread_join(thread, NULL);
	_exit(0);
}

static void read_result(int from, pid_t copy, double longest, struct ts_price *out)
{
	struct pollfd wait = { .fd = from, .events = POLLIN };
	const int answers = poll(&wait, 1, (int)(1000 * longest));

	if (answers != 1 || read(from, out, sizeof *out) != sizeof *out)
		*out = (struct ts_price){ .seconds = NAN };
	if (answers == 0)
		snprintf(out->why, sizeof out->why, "the first steps take more than %.2g s", longest);
	kill(copy, SIGKILL);
	while (waitpid(copy, NULL, 0) < 0 && errno == EINTR)
		continue;
}

static void run_trial_process(struct trial *t, struct ts_price *out)
{
	const double longest = fmax(LONGEST - t->sim->cost.tried, LONGEST_LATER);
	int ends[2];
	pid_t copy;

	*out = (struct ts_price){ .seconds = NAN };
	if (pipe(ends) != 0)
		return;
	t->to = ends[1];
	fflush(NULL); /* otherwise the copy would write buffered output a second time */
	copy = fork();
	if (copy == 0)
		run_child(t);
	close(ends[1]);
	if (copy > 0)
		read_result(ends[0], copy, longest, out);
	close(ends[0]);
}

enum ts_status ts_price_steps(struct ts_plan *plan, struct tsim *sim, struct ts_price *out)
{
	struct trial t = { .plan = plan, .sim = sim };
	double start = ts_clock();

	t.steps = sim->clock.last_step - sim->clock.step;
	t.budget = fmin(TRIAL, TRIALS - sim->cost.tried);
	*out = sim->cost.last;
	out->steps = 0;
	out->frames = 0;
	if (t.steps < 1 || (t.budget <= 0 && isfinite(sim->cost.last.seconds)))
		return TS_OK;
	run_trial_process(&t, out);
	sim->cost.tried += ts_clock() - start;
	sim->cost.last = *out;
	return TS_OK;
}

enum ts_status ts_price_full(struct ts_plan *plan, struct tsim *sim, unsigned part, double *out)
{
	struct trial t = { .plan = plan, .sim = sim, .full = part };
	double start = ts_clock();
	struct ts_price price;

	t.steps = sim->clock.last_step - sim->clock.step;
	t.budget = fmin(PART, TRIALS - sim->cost.tried);
	*out = NAN;
	if (t.steps < 1 || t.budget <= 0)
		return TS_OK;
	run_trial_process(&t, &price);
	sim->cost.tried += ts_clock() - start;
	if (price.steps > 2) /* the first step is not counted: its data are not in the cache */
		*out = price.seconds;
	return TS_OK;
}

/* Below `least` seconds the next smaller unit is used. */
void ts_price_time(double seconds, struct ts_str *out)
{
	static const struct {
		double least;
		const char *name;
	} unit[] = { { 2 * 86400, "days" }, { 2 * 3600, "h" }, { 2 * 60, "min" }, { 1, "s" },
		     { 1e-3, "ms" },	    { 1e-6, "us" } };
	static const double length[] = { 86400, 3600, 60, 1, 1e-3, 1e-6 };
	size_t k = 0;

	while (k < 5 && seconds < unit[k].least)
		k++;
	ts_str_addf(out, "%.3g %s", seconds / length[k], unit[k].name);
}

void ts_price_bytes(double bytes, struct ts_str *out)
{
	static const char *const unit[] = { "bytes", "kB", "MB", "GB", "TB" };
	size_t k = 0;

	for (; k < 4 && bytes >= 1000; k++)
		bytes /= 1000;
	ts_str_addf(out, "%.3g %s", bytes, unit[k]);
}
