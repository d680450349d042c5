#include "advise/advise.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "advise/candidates.h"
#include "advise/trial.h"
#include "advise/verdict.h"
#include "base/clock.h"
#include "core/arg.h"
#include "crosscheck/folder.h"
#include "crosscheck/inputs.h"
#include "neigh/neigh.h"
#include "particle/particles.h"
#include "script/diagnostic.h"
#include "script/script.h"

#include "base/banned.h"

/* Fractions of the time limit for the execution up to the start of the trials, for the trials, and for the
 * measurement of a step. */
static const double APPROACH = 0.3, TRIALS = 0.6, PROBE = 0.02;
enum { MOST_REPEATS = 3, MOST_ROUNDS = 5 };

struct options {
	double seconds, tolerance;
	int64_t at, steps;
};

static const struct ts_arg rows[] = {
	TS_REAL("seconds", struct options, seconds, .flags = TS_POSITIONAL, .fallback = "60",
		.range = TS_POSITIVE, .unit = "s", .help = "approximate total wall time"),
	TS_INT("at", struct options, at, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE, .unit = "step",
	       .help = "step at which the trials start; default: the step reached after 30 % of the time, "
		       "or, if the script ends earlier, the start of the run with the most work"),
	TS_INT("steps", struct options, steps, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "step",
	       .help = "length of a trial in steps of the script; default: as long as the time allows"),
	TS_REAL("tolerance", struct options, tolerance, .fallback = "0.01", .range = TS_POSITIVE, .unit = "",
		.help = "largest change of a column, relative to its range, that advised settings may cause"),
	TS_ARGS_END,
};

struct advise {
	struct tsim *sim;
	const struct ts_advise_input *in;
	struct options o;
	struct ts_trial_results *results;
	double begin;
};

/* ---- execution up to the start of the trials, in the child process */

/* Called before and after each run command. */
struct approach {
	struct ts_run_watch watch; /* first */
	struct ts_trial_results *results;
	int64_t wanted;	 /* index of the run at whose beginning to stop; -1: none */
	int64_t at;	 /* step at which to stop; -1: none */
	int64_t last;	 /* last step of the present run, as in the script */
	double deadline; /* wall-clock time at which to stop (s); 0: none */
};

static enum ts_status stop_at_start(struct approach *w, struct tsim *sim)
{
	struct ts_trial_results *b = w->results;

	b->started = true;
	b->step = sim->clock.step;
	b->steps_left = w->last - sim->clock.step;
	b->particles = (int64_t)sim->particles->n;
	b->time = ts_sim_time(sim);
	b->dt = sim->clock.dt;
	b->threads = sim->threads;
	return ts_fail(&sim->error, TS_STOPPED, NULL, "start of the trials");
}

static enum ts_status before_run(struct ts_run_watch *watch, struct tsim *sim, const struct ts_place *where,
				 int64_t *last)
{
	struct approach *w = (struct approach *)watch;
	struct ts_trial_results *b = w->results;
	int64_t n = *last - sim->clock.step;
	double work = (double)n * (1 + (double)sim->particles->n);

	w->last = *last;
	b->run_steps = n;
	snprintf(b->location, sizeof b->location, "%s:%d: run of %" PRId64 " steps",
		 where->file ? where->file : "script", where->line, n);
	if (n > 0 && (b->runs == w->wanted || sim->clock.step == w->at))
		return stop_at_start(w, sim);
	if (work > b->work) {
		b->work = work;
		b->costliest = b->runs;
	}
	b->runs++;
	if (w->at > sim->clock.step && w->at < *last)
		*last = w->at;
	sim->run.timeout = w->deadline;
	sim->run.timeout_every = 1;
	return TS_OK;
}

static enum ts_status after_run(struct ts_run_watch *watch, struct tsim *sim)
{
	struct approach *w = (struct approach *)watch;

	if (sim->clock.step == w->at && w->last > w->at)
		return stop_at_start(w, sim);
	if (!sim->run.halted || !(w->deadline > 0) || ts_clock() < w->deadline || sim->clock.step >= w->last)
		return TS_OK;
	w->results->out_of_time = true;
	return stop_at_start(w, sim);
}

/* Rounds down to 1, 2 or 5 times a power of ten, and to a multiple of the number of samples. */
static int64_t round_steps(double n)
{
	double power = pow(10, floor(log10(n)));
	double lead = n / power;

	n = (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
	return n < TS_TRIAL_SAMPLES ? TS_TRIAL_SAMPLES : (int64_t)n / TS_TRIAL_SAMPLES * TS_TRIAL_SAMPLES;
}

/* Expected cost of a trial, relative to the present settings. */
static double relative_cost(const struct ts_trial_results *b, const struct ts_trial *t)
{
	return t->dt > 0 ? b->dt / t->dt : 1;
}

static void choose_steps(struct advise *a)
{
	struct ts_trial_results *b = a->results;
	double sum = 1, n;

	for (int k = 0; k < b->n; k++)
		sum += relative_cost(b, &b->trial[k]);
	n = TRIALS * a->o.seconds / (sum * fmax(b->step_seconds, 1e-9));
	if (a->o.steps > 0)
		b->steps = a->o.steps;
	else
		b->steps =
			n >= (double)b->steps_left ? b->steps_left : round_steps(fmax(n, TS_TRIAL_SAMPLES));
	b->steps = b->steps > b->steps_left ? b->steps_left : b->steps;
	if (b->steps > TS_TRIAL_SAMPLES)
		b->steps -= b->steps % TS_TRIAL_SAMPLES;
	n = n / (double)b->steps;
	b->repeats = n < 1 ? 1 : n > MOST_REPEATS ? MOST_REPEATS : (int)n;
}

static void run_trial(struct advise *a, int k, struct ts_log *screen)
{
	struct ts_trial_results *b = a->results;
	double expected = relative_cost(b, &b->trial[k]) * (double)b->steps * b->step_seconds;
	char text[160];

	snprintf(text, sizeof text, "trial %d of %d: %s", k + 1, b->n, b->trial[k].label);
	ts_log_progress(screen, text);
	if (k && a->o.steps <= 0 && ts_clock() - a->begin + 0.5 * expected > 1.2 * a->o.seconds)
		return;
	ts_trial_run(a->sim, b, k, a->o.steps > 0 ? 1e9 : fmax(2, 15 * expected));
}

/* Repeats the trials that are cheaper by less than the scatter of the times, and the two trials with the
 * present settings, until they are decided or the time is used up. */
static void repeat_undecided(struct advise *a, struct ts_log *screen)
{
	struct ts_trial_results *b = a->results;
	bool open = true;

	ts_log_progress(screen, "repeating undecided trials");
	for (int round = 0; open && round < MOST_ROUNDS; round++) {
		open = false;
		for (int k = 0; k < b->n; k++) {
			double expected = relative_cost(b, &b->trial[k]) * (double)b->steps * b->step_seconds;

			if (!b->trial[k].done || ts_clock() - a->begin + 3 * expected > a->o.seconds ||
			    !ts_verdict_open(b, k))
				continue;
			open = true;
			for (int same = 0; same < b->n && b->trial[same].subject <= TS_SUBJECT_PERTURBED;
			     same++)
				if (b->trial[same].done)
					ts_trial_repeat(a->sim, b, same, fmax(2, 15 * expected));
			ts_trial_repeat(a->sim, b, k, fmax(2, 15 * expected));
		}
	}
}

static void run_all_trials(struct advise *a, struct ts_log *screen)
{
	struct ts_trial_results *b = a->results;

	ts_trial_probe(a->sim, b, fmin(1, PROBE * a->o.seconds));
	if (*b->failure)
		return;
	/* without particles the default skin is not known yet */
	b->skin = a->sim->neigh->wanted && (a->sim->neigh->skin > 0 || a->sim->particles->n)
			  ? ts_neigh_skin(a->sim)
			  : 0;
	ts_candidates_list(a->sim, b);
	choose_steps(a);
	for (int k = 0; k < b->n; k++)
		run_trial(a, k, screen);
	repeat_undecided(a, screen);
	if (ts_verdict_combine(b, a->o.tolerance))
		run_trial(a, b->n - 1, screen);
	ts_log_progress(screen, "");
}

static void store_failure(struct advise *a)
{
	struct ts_str text = { 0 };

	ts_diagnostic(&a->sim->error, &text);
	snprintf(a->results->failure, sizeof a->results->failure, "%s", ts_str_text(&text));
	ts_str_release(&text);
}

/* The child works in another folder, but coefficient files are still to be found in the folder `potentials`
 * of the present one. */
static void export_potentials(void)
{
	char here[4096], path[4096 + 16];

	if (!getcwd(here, sizeof here))
		return;
	snprintf(path, sizeof path, "%s/potentials", here);
	if (access(path, X_OK) == 0)
		setenv("TSIM_POTENTIALS", path, 0);
}

/* Does not return. wanted -1: stops when the time for this part is used up. */
static void run_child(struct advise *a, const char *place, int64_t wanted)
{
	struct tsim *sim = a->sim;
	struct ts_log screen = sim->log;
	struct approach w = { .watch = { before_run, after_run },
			      .results = a->results,
			      .wanted = wanted,
			      .at = a->o.at >= 0 ? a->o.at : -1 };
	enum ts_status status;

	signal(SIGINT, SIG_DFL);
	sim->log.screen = sim->log.file = NULL;
	sim->log.progress = false;
	sim->run.watch = &w.watch;
	w.deadline = w.at < 0 && wanted < 0 ? ts_clock() + APPROACH * a->o.seconds : 0;
	ts_log_progress(&screen, "running the script up to the start of the trials");
	export_potentials();
	status = chdir(place) == 0 ? ts_script_file(sim->script_api_data, a->in->script)
				   : ts_fail(&sim->error, TS_IO, NULL, "cannot change to folder '%s': %s",
					     place, strerror(errno));
	if (a->results->started) {
		ts_error_clear(&sim->error);
		sim->run.watch = NULL;
		run_all_trials(a, &screen);
	} else if (status != TS_OK) {
		store_failure(a);
	}
	ts_log_progress(&screen, "");
	fflush(NULL);
	_exit(0);
}

/* ---- the parent process */

/* Starts a child in a new copy of the input files of the script, and waits for it. */
static enum ts_status run_in_child(struct advise *a, struct ts_inputs *inputs, const char *root,
				   int64_t wanted)
{
	struct ts_str place = { 0 }, folder = { 0 };
	enum ts_status status;
	int ended = 0;
	pid_t child;

	ts_str_addf(&folder, "%s/%s", root, wanted < 0 ? "way" : "again");
	status = folder.failed ? ts_nomem(&a->sim->error)
			       : ts_inputs_copy(inputs, ts_str_text(&folder), &place);
	ts_str_release(&folder);
	if (status == TS_OK) {
		fflush(NULL);
		child = fork();
		if (child == 0)
			run_child(a, ts_str_text(&place), wanted);
		if (child < 0)
			status = ts_fail(&a->sim->error, TS_IO, NULL, "cannot start a process: %s",
					 strerror(errno));
		while (child > 0 && waitpid(child, &ended, 0) < 0 && errno == EINTR)
			continue;
	}
	ts_str_release(&place);
	if (status == TS_OK && WIFSIGNALED(ended))
		status = ts_fail(&a->sim->error, TS_STOPPED, NULL, "the trials were terminated by signal %d",
				 WTERMSIG(ended));
	return status;
}

/* If the script ends before the time is used up, it is executed again up to the run with the most work. */
static enum ts_status find_start_and_try(struct advise *a, struct ts_inputs *inputs, const char *root)
{
	struct ts_trial_results *b = a->results;

	TS_TRY(run_in_child(a, inputs, root, -1));
	if (b->started || *b->failure)
		return TS_OK;
	if (!(b->work > 0))
		return ts_fail(&a->sim->error, TS_STATE, NULL, "-advise: the script runs no time steps");
	if (a->o.at >= 0)
		return ts_fail(&a->sim->error, TS_RANGE, NULL,
			       "-advise: the script has no run that continues after step %" PRId64, a->o.at);
	b->runs = 0;
	TS_TRY(run_in_child(a, inputs, root, b->costliest));
	if (b->started || *b->failure)
		return TS_OK;
	return ts_fail(&a->sim->error, TS_STATE, NULL,
		       "-advise: the second execution of the script differs from the first");
}

static enum ts_status advise_in_scratch_folder(struct advise *a)
{
	struct ts_error *err = &a->sim->error;
	struct ts_inputs inputs = { .err = err, .pool = a->sim->pool };
	struct ts_str root = { 0 };
	enum ts_status status = ts_inputs_find(&inputs, a->in->script, a->in->vars);

	if (status == TS_OK)
		status = ts_folder_scratch(&root, err);
	if (status == TS_OK) {
		void (*handler)(int) =
			signal(SIGINT, SIG_IGN); /* ends the child; then the folder is removed */

		status = find_start_and_try(a, &inputs, ts_str_text(&root));
		signal(SIGINT, handler);
		ts_folder_remove(ts_str_text(&root));
	}
	ts_inputs_release(&inputs);
	ts_str_release(&root);
	return status;
}

static int advise_and_report(struct advise *a, struct ts_str *text, struct ts_str *trouble)
{
	a->results =
		mmap(NULL, sizeof *a->results, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
	if (a->results == MAP_FAILED) {
		ts_nomem(&a->sim->error);
		return 1;
	}
	a->begin = ts_clock();
	if (advise_in_scratch_folder(a) == TS_OK && !*a->results->failure)
		ts_verdict_print(a->results, a->o.tolerance, text);
	ts_str_add(trouble, a->results->failure);
	munmap(a->results, sizeof *a->results);
	return a->sim->error.status || trouble->length ? 1 : 0;
}

int ts_advise(struct tsim *sim, const struct ts_advise_input *input, struct ts_str *text,
	      struct ts_str *trouble)
{
	struct advise a = { .sim = sim, .in = input };
	struct ts_place where = { .file = "-advise" };
	struct ts_arena arena = { 0 };
	int status = 2;

	if (!input->script)
		ts_fail(&sim->error, TS_SYNTAX, NULL, "-advise needs a script: -in FILE");
	else if (ts_args_parse(sim, "-advise", rows, input->words, &where, &arena, &a.o) == TS_OK)
		status = advise_and_report(&a, text, trouble);
	ts_arena_release(&arena);
	return status;
}

void ts_advise_help(struct ts_str *out)
{
	for (const struct ts_arg *row = rows; row->type != TS_ARG_END; row++) {
		struct ts_str synopsis = { 0 };

		ts_arg_synopsis(row, &synopsis);
		ts_str_addf(out, "  %-22s %s", ts_str_text(&synopsis), row->help);
		ts_str_addf(out, row->fallback ? " (%s)\n" : "\n", row->fallback);
		out->failed |= synopsis.failed;
		ts_str_release(&synopsis);
	}
}
