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
#include "script/script.h"

#include "base/banned.h"

/* Parts of the time that may be spent: on the way to where the trials start, on the trials. */
static const double WAY = 0.3, TRIALS = 0.6, PROBE = 0.02;
enum { MOST_REPEATS = 3, MOST_ROUNDS = 5 };

struct options {
	double seconds, tolerance;
	int64_t at, steps;
};

static const struct ts_arg rows[] = {
	TS_REAL("seconds", struct options, seconds, .flags = TS_POSITIONAL, .fallback = "60",
		.range = TS_POSITIVE, .unit = "s", .help = "how long all of it may take, about"),
	TS_INT("at", struct options, at, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE, .unit = "step",
	       .help = "the step at which trials start; without it, as far as the script comes in a third of "
		       "the time, or where the run begins that does most"),
	TS_INT("steps", struct options, steps, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "step",
	       .help = "length of a trial in steps of the script; without it, as long as the time allows"),
	TS_REAL("tolerance", struct options, tolerance, .fallback = "0.01", .range = TS_POSITIVE, .unit = "",
		.help = "what is advised changes no column by more, in parts of what it goes through"),
	TS_ARGS_END,
};

struct advise {
	struct tsim *sim;
	const struct ts_advise_input *in;
	struct options o;
	struct ts_board *board;
	double begin;
};

/* ---- on the way, in the child */

struct way {
	struct ts_run_watch watch; /* first */
	struct ts_board *board;
	int64_t wanted; /* number of the run before which to stop; -1: none */
	int64_t at;	/* step at which to stop; -1: none */
	int64_t last;	/* of the run that runs, as the script has it */
	double deadline;
};

static enum ts_status arrive(struct way *w, struct tsim *sim)
{
	struct ts_board *b = w->board;

	b->arrived = true;
	b->step = sim->clock.step;
	b->left = w->last - sim->clock.step;
	b->particles = (int64_t)sim->particles->n;
	b->time = ts_sim_time(sim);
	b->dt = sim->clock.dt;
	b->threads = sim->threads;
	return ts_fail(&sim->error, TS_STOPPED, NULL, "here the trials start");
}

static enum ts_status before(struct ts_run_watch *watch, struct tsim *sim, const struct ts_place *where,
			     int64_t *last)
{
	struct way *w = (struct way *)watch;
	struct ts_board *b = w->board;
	int64_t n = *last - sim->clock.step;
	double work = (double)n * (1 + (double)sim->particles->n);

	w->last = *last;
	b->whole = n;
	snprintf(b->place, sizeof b->place, "%s:%d: run of %" PRId64 " steps",
		 where->file ? where->file : "script", where->line, n);
	if (n > 0 && (b->runs == w->wanted || sim->clock.step == w->at))
		return arrive(w, sim);
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

static enum ts_status after(struct ts_run_watch *watch, struct tsim *sim)
{
	struct way *w = (struct way *)watch;

	if (sim->clock.step == w->at && w->last > w->at)
		return arrive(w, sim);
	if (!sim->run.halted || !(w->deadline > 0) || ts_clock() < w->deadline || sim->clock.step >= w->last)
		return TS_OK;
	w->board->cut = true;
	return arrive(w, sim);
}

/* 1, 2 or 5 times a power of ten, in parts of which the columns can be looked at. */
static int64_t round_steps(double n)
{
	double power = pow(10, floor(log10(n)));
	double lead = n / power;

	n = (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
	return n < TS_TRIAL_LOOKS ? TS_TRIAL_LOOKS : (int64_t)n / TS_TRIAL_LOOKS * TS_TRIAL_LOOKS;
}

/* What a trial costs in parts of the scene as it is. */
static double factor(const struct ts_board *b, const struct ts_trial *t)
{
	return t->dt > 0 ? b->dt / t->dt : 1;
}

static void choose_steps(struct advise *a)
{
	struct ts_board *b = a->board;
	double sum = 1, n;

	for (int k = 0; k < b->n; k++)
		sum += factor(b, &b->trial[k]);
	n = TRIALS * a->o.seconds / (sum * fmax(b->step_seconds, 1e-9));
	if (a->o.steps > 0)
		b->steps = a->o.steps;
	else
		b->steps = n >= (double)b->left ? b->left : round_steps(fmax(n, TS_TRIAL_LOOKS));
	b->steps = b->steps > b->left ? b->left : b->steps;
	if (b->steps > TS_TRIAL_LOOKS)
		b->steps -= b->steps % TS_TRIAL_LOOKS;
	n = n / (double)b->steps;
	b->repeats = n < 1 ? 1 : n > MOST_REPEATS ? MOST_REPEATS : (int)n;
}

static void try_one(struct advise *a, int k, struct ts_log *screen)
{
	struct ts_board *b = a->board;
	double expected = factor(b, &b->trial[k]) * (double)b->steps * b->step_seconds;
	char text[160];

	snprintf(text, sizeof text, "trial %d of %d: %s", k + 1, b->n, b->trial[k].label);
	ts_log_progress(screen, text);
	if (k && a->o.steps <= 0 && ts_clock() - a->begin + 0.5 * expected > 1.2 * a->o.seconds)
		return;
	ts_trial_run(a->sim, b, k, a->o.steps > 0 ? 1e9 : fmax(2, 15 * expected));
}

/* What seems worth it, but by no more than times differ, is measured again, with the scene as it is and
 * its twin, until it is decided or the time is over. */
static void decide(struct advise *a, struct ts_log *screen)
{
	struct ts_board *b = a->board;
	bool open = true;

	ts_log_progress(screen, "measured again: what is not decided");
	for (int round = 0; open && round < MOST_ROUNDS; round++) {
		open = false;
		for (int k = 0; k < b->n; k++) {
			double expected = factor(b, &b->trial[k]) * (double)b->steps * b->step_seconds;

			if (!b->trial[k].done || ts_clock() - a->begin + 3 * expected > a->o.seconds ||
			    !ts_verdict_open(b, k))
				continue;
			open = true;
			for (int same = 0; same < b->n && b->trial[same].subject <= TS_SUBJECT_TWIN; same++)
				if (b->trial[same].done)
					ts_trial_repeat(a->sim, b, same, fmax(2, 15 * expected));
			ts_trial_repeat(a->sim, b, k, fmax(2, 15 * expected));
		}
	}
}

static void try_all(struct advise *a, struct ts_log *screen)
{
	struct ts_board *b = a->board;

	ts_trial_probe(a->sim, b, fmin(1, PROBE * a->o.seconds));
	if (*b->trouble)
		return;
	b->skin = a->sim->neigh->wanted ? ts_neigh_skin(a->sim) : 0;
	ts_candidates_list(a->sim, b);
	choose_steps(a);
	for (int k = 0; k < b->n; k++)
		try_one(a, k, screen);
	decide(a, screen);
	if (ts_verdict_combine(b, a->o.tolerance))
		try_one(a, b->n - 1, screen);
	ts_log_progress(screen, "");
}

static void note_trouble(struct advise *a)
{
	struct ts_str text = { 0 };

	ts_diagnostic(&a->sim->error, &text);
	snprintf(a->board->trouble, sizeof a->board->trouble, "%s", ts_str_text(&text));
	ts_str_release(&text);
}

/* Coefficient files are looked for in the folder `potentials` of where the user is. */
static void keep_potentials(void)
{
	char here[4096], path[4096 + 16];

	if (!getcwd(here, sizeof here))
		return;
	snprintf(path, sizeof path, "%s/potentials", here);
	if (access(path, X_OK) == 0)
		setenv("TSIM_POTENTIALS", path, 0);
}

/* Never comes back. wanted -2: wherever the time ends. */
static void be_child(struct advise *a, const char *place, int64_t wanted)
{
	struct tsim *sim = a->sim;
	struct ts_log screen = sim->log;
	struct way w = { .watch = { before, after },
			 .board = a->board,
			 .wanted = wanted,
			 .at = a->o.at >= 0 ? a->o.at : -1 };
	enum ts_status status;

	signal(SIGINT, SIG_DFL);
	sim->log.screen = sim->log.file = NULL;
	sim->log.progress = false;
	sim->run.watch = &w.watch;
	w.deadline = w.at < 0 && wanted < 0 ? ts_clock() + WAY * a->o.seconds : 0;
	ts_log_progress(&screen, "on the way to where trials start");
	keep_potentials();
	status = chdir(place) == 0 ? ts_script_file(sim->script_api_data, a->in->script)
				   : ts_fail(&sim->error, TS_IO, NULL, "cannot work in '%s': %s", place,
					     strerror(errno));
	if (a->board->arrived) {
		ts_error_clear(&sim->error);
		sim->run.watch = NULL;
		try_all(a, &screen);
	} else if (status != TS_OK) {
		note_trouble(a);
	}
	ts_log_progress(&screen, "");
	fflush(NULL);
	_exit(0);
}

/* ---- the parent */

/* Lets a child go the way in a fresh copy of the script's inputs. */
static enum ts_status go(struct advise *a, struct ts_inputs *inputs, const char *root, int64_t wanted)
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
			be_child(a, ts_str_text(&place), wanted);
		if (child < 0)
			status = ts_fail(&a->sim->error, TS_IO, NULL, "cannot start a process: %s",
					 strerror(errno));
		while (child > 0 && waitpid(child, &ended, 0) < 0 && errno == EINTR)
			continue;
	}
	ts_str_release(&place);
	if (status == TS_OK && WIFSIGNALED(ended))
		status = ts_fail(&a->sim->error, TS_STOPPED, NULL, "the trials were ended by signal %d",
				 WTERMSIG(ended));
	return status;
}

/* A script that is over before the time is gone through again, up to the run that does most. */
static enum ts_status rehearse(struct advise *a, struct ts_inputs *inputs, const char *root)
{
	struct ts_board *b = a->board;

	TS_TRY(go(a, inputs, root, -1));
	if (b->arrived || *b->trouble)
		return TS_OK;
	if (!(b->work > 0))
		return ts_fail(&a->sim->error, TS_STATE, NULL,
			       "-advise: the script runs no steps to try settings with");
	if (a->o.at >= 0)
		return ts_fail(&a->sim->error, TS_RANGE, NULL,
			       "-advise: the script has no run that goes on from step %" PRId64, a->o.at);
	b->runs = 0;
	TS_TRY(go(a, inputs, root, b->costliest));
	if (b->arrived || *b->trouble)
		return TS_OK;
	return ts_fail(&a->sim->error, TS_STATE, NULL,
		       "-advise: the script does not do the same when it is run again");
}

static enum ts_status in_scratch(struct advise *a)
{
	struct ts_error *err = &a->sim->error;
	struct ts_inputs inputs = { .err = err, .pool = a->sim->pool };
	struct ts_str root = { 0 };
	enum ts_status status = ts_inputs_find(&inputs, a->in->script, a->in->vars);

	if (status == TS_OK)
		status = ts_folder_scratch(&root, err);
	if (status == TS_OK) {
		void (*handler)(int) = signal(SIGINT, SIG_IGN); /* ends the child; the folder goes, too */

		status = rehearse(a, &inputs, ts_str_text(&root));
		signal(SIGINT, handler);
		ts_folder_remove(ts_str_text(&root));
	}
	ts_inputs_release(&inputs);
	ts_str_release(&root);
	return status;
}

static int act(struct advise *a, struct ts_str *text, struct ts_str *trouble)
{
	a->board = mmap(NULL, sizeof *a->board, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
	if (a->board == MAP_FAILED) {
		ts_nomem(&a->sim->error);
		return 1;
	}
	a->begin = ts_clock();
	if (in_scratch(a) == TS_OK && !*a->board->trouble)
		ts_verdict_print(a->board, a->o.tolerance, text);
	ts_str_add(trouble, a->board->trouble);
	munmap(a->board, sizeof *a->board);
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
		status = act(&a, text, trouble);
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
