/* Commands run and run_time: run the simulation for N steps, or for a time. */
#include "core/plan.h"

#include <inttypes.h>
#include <math.h>

#include "base/clock.h"
#include "core/ranks.h"
#include "core/ranks_pause.h"
#include "core/restored_models.h"
#include "neigh/neigh.h"
#include "particle/division.h"
#include "particle/particles.h"

#include "base/banned.h"

struct run {
	int64_t steps, start, stop;
	bool upto, pre, post, unsafe;
	struct ts_words pieces; /* arguments of `every`: M and the commands executed every M steps */
	const struct ts_place *where;
};

static void print_times(const struct ts_plan *plan, struct tsim *sim, double wall)
{
	for (int part = 0; part < TS_PLAN_PARTS; part++) {
		const double seconds = ts_plan_part_seconds(plan, part);

		ts_log(&sim->log, "%-5s time (%%) = %g (%.3g)\n", ts_plan_part_name(part), seconds,
		       wall > 0 ? 100 * seconds / wall : 0);
	}
}

/* What the ranks have sent since the last run. */
static void print_ranks(struct tsim *sim, int64_t steps, size_t n)
{
	struct ts_division *d = sim->particles->division;
	struct ts_world_counts *c;
	const int *count;

	if (!d || !steps)
		return;
	c = &sim->world->counts;
	count = d->blocks.count;
	ts_log(&sim->log, "Ranks: %d as ", sim->world->n);
	if (d->blocks.bisection)
		ts_log(&sim->log, "blocks of a recursive bisection");
	else
		ts_log(&sim->log, "%d x %d x %d blocks", count[0], count[1], count[2]);
	ts_log(&sim->log, ", %zu to %zu particles each, imbalance %.3g\n", d->least, d->most,
	       n ? (double)d->most * sim->world->n / (double)n : 1);
	ts_log(&sim->log,
	       "Of the first rank: %.1f messages, %.0f bytes and %.2f agreements a step, %.0f copies of "
	       "particles, %" PRId64 " particles received; all gathered %" PRId64 " times, %" PRId64
	       " of them with contacts\n\n",
	       (double)c->messages / (double)steps, (double)c->bytes / (double)steps,
	       (double)c->agreements / (double)steps, d->built ? (double)d->made / (double)d->built : 0,
	       d->moved, d->gathered, d->listed);
	*c = (struct ts_world_counts){ 0 };
	d->built = d->made = d->moved = d->gathered = d->listed = 0;
}

/* Ghosts, and candidate pairs; where ranks have not made the lists of all particles, those of all ranks together: copies, and
 * pairs of two ranks twice. */
static void count_rows(const struct tsim *sim, int64_t number[2])
{
	const struct ts_particles *p = sim->particles;

	number[0] = (int64_t)(sim->run.looks ? p->division->look.nghost : p->nghost);
	number[1] = (int64_t)sim->neigh->contacts.n;
	if (sim->run.looks || sim->division)
		ts_ranks_sums(sim, number, 2);
}

static void print_footer(const struct ts_plan *plan, struct tsim *sim, int64_t steps)
{
	double wall = ts_clock() - sim->clock.wall_start;
	const struct ts_particles *p = sim->particles;
	const size_t n = (size_t)ts_division_sum(sim, (int64_t)p->n);
	int64_t number[2];

	ts_log(&sim->log, "Loop time of %g on %d procs for %" PRId64 " steps with %zu atoms\n", wall,
	       sim->threads * ts_ranks(sim), steps, n);
	if (steps && n)
		ts_log(&sim->log, "%.1f ns per particle-step\n\n", 1e9 * wall / ((double)steps * (double)n));
	print_times(plan, sim, wall);
	count_rows(sim, number);
	ts_log(&sim->log, "\nNlocal: %zu\nNghost: %" PRId64 "\nNeighs: %" PRId64 "\n", n, number[0],
	       number[1]);
	ts_log(&sim->log, "Neighbor list builds = %" PRId64 "\nDangerous builds = 0\n\n", sim->neigh->builds);
	print_ranks(sim, steps, n);
	if (p->lost)
		ts_log(&sim->log, "Particles lost through fixed faces so far: %" PRId64 "\n", p->lost);
}

static enum ts_status run_plan(struct ts_plan *plan, struct tsim *sim, int64_t steps, const struct run *r)
{
	sim->clock.first_step = sim->clock.step;
	sim->clock.last_step = sim->clock.step + steps;
	sim->run.unsafe = r->unsafe;
	if (sim->reading.explain && sim->script_api)
		TS_TRY(sim->script_api->planned(sim->script_api_data, r->where, steps));
	TS_TRY(ts_sim_defer_error(sim, ts_restore_models(sim)));
	TS_TRY(ts_plan_compile(plan, sim));
	TS_TRY(ts_plan_run(plan, sim, r->pre));
	steps = sim->clock.step - sim->clock.first_step; /* fix halt may have ended it early */
	if (sim->reading.explain)
		return TS_OK;
	if (r->post)
		print_footer(plan, sim, steps);
	else
		ts_log(&sim->log, "Loop time of %g on %d procs for %" PRId64 " steps with %zu atoms\n",
		       ts_clock() - sim->clock.wall_start, sim->threads * ts_ranks(sim), steps,
		       (size_t)ts_division_sum(sim, (int64_t)sim->particles->n));
	return TS_OK;
}

static enum ts_status run_once(struct tsim *sim, int64_t steps, const struct run *r)
{
	struct ts_plan plan = { 0 };
	enum ts_status status;

	if (!ts_ranks_rowless(sim))
		TS_TRY(ts_ranks_look(sim));
	ts_ranks_end_pause(sim);
	status = run_plan(&plan, sim, steps, r);
	if (status == TS_OK && (sim->run.looks || sim->division))
		status = ts_ranks_pause(sim, &plan);
	ts_plan_release(&plan);
	return status;
}

/* Whether a command of `every` has ended the run or the script. */
static bool has_ended(const struct tsim *sim)
{
	return sim->run.halted || sim->script_api->has_quit(sim->script_api_data);
}

/* Runs in pieces of M steps and executes the commands after each; their variables are substituted each
 * time. */
static enum ts_status run_with_commands(struct tsim *sim, int64_t last, const struct run *r)
{
	const struct ts_word *word = r->pieces.word;
	int64_t every, left = last - sim->clock.step;
	bool first = true; /* of no steps, too */

	if (!ts_parse_int(word[0].text, &every) || every < 1)
		return ts_fail(&sim->error, TS_SYNTAX, &word[0].place,
			       "run: every is '%s', expected a number of steps > 0", word[0].text);
	if (sim->reading.explain) /* a single piece: the commands are read once */
		every = last - sim->clock.step;
	else
		TS_TRY(sim->script_api->check_commands(sim->script_api_data, ts_words_from(r->pieces, 1)));
	for (; (first || left > 0) && !has_ended(sim); first = false) {
		if (!ts_sim_has_box(sim))
			return ts_fail(&sim->error, TS_STATE, &word[0].place,
				       "run: a command of `every` has removed the box, and the run cannot go "
				       "on for %" PRId64 " steps more; use `clear` after the run",
				       left);
		TS_TRY(run_once(sim, left < every ? left : every, r));
		left -= every; /* not from clock.step: a command may reset it */
		for (size_t k = 1; k < r->pieces.n; k++)
			if (!ts_streq(word[k].text, "NULL"))
				TS_TRY(sim->script_api->execute(sim->script_api_data, word[k].text,
								&word[k].place));
	}
	return TS_OK;
}

static enum ts_status run_pieces(struct tsim *sim, int64_t last, const struct run *r)
{
	enum ts_status status;

	sim->script_api->expect_commands(sim->script_api_data, ts_words_from(r->pieces, 1));
	status = run_with_commands(sim, last, r);
	sim->script_api->expect_commands(sim->script_api_data, (struct ts_words){ 0 });
	return status;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct run *r = state;
	int64_t last;

	if (!r->upto && r->steps > INT64_MAX - sim->clock.step)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "run: the last step would be out of range, at most %" PRId64, INT64_MAX);
	last = r->upto ? r->steps : sim->clock.step + r->steps;
	r->where = where;
	if (last < sim->clock.step && sim->reading.open_clock) /* -explain: the step is not exactly known */
		last = sim->clock.step;
	if (last < sim->clock.step)
		return ts_fail(&sim->error, TS_RANGE, ts_sim_word(sim, 1, where),
			       "run upto %" PRId64 ": the simulation is already at step %" PRId64, r->steps,
			       sim->clock.step);
	if ((r->start >= 0 && r->start > sim->clock.step) || (r->stop >= 0 && r->stop < last))
		return ts_fail(&sim->error, TS_RANGE, where,
			       "run: start must not be after the current step %" PRId64
			       ", stop not before the last %" PRId64,
			       sim->clock.step, last);
	if (sim->run.watch)
		TS_TRY(sim->run.watch->before(sim->run.watch, sim, where, &last));
	sim->clock.command_step = sim->clock.step;
	sim->clock.goal = last;
	sim->clock.ramp_first = r->start >= 0 ? r->start : sim->clock.step;
	sim->clock.ramp_last = r->stop >= 0 ? r->stop : last;
	if (sim->run.halted) {
		ts_log(&sim->log, "This run is skipped: fix halt has ended one before\n");
		return TS_OK;
	}
	if (!r->pieces.n)
		TS_TRY(run_once(sim, last - sim->clock.step, r));
	else
		TS_TRY(run_pieces(sim, last, r));
	return sim->run.watch ? sim->run.watch->after(sim->run.watch, sim) : TS_OK;
}

static const struct ts_arg args[] = {
	TS_INT("N", struct run, steps, .flags = TS_POSITIONAL | TS_CUT, .range = TS_NOT_NEGATIVE,
	       .help = "number of steps"),
	TS_FLAG("upto", struct run, upto, .help = "run until step N instead of N more steps"),
	TS_INT("start", struct run, start, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE,
	       .help = "step at which changes over a run (ramp(), fix deform final) begin"),
	TS_INT("stop", struct run, stop, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE,
	       .help = "step at which they end"),
	TS_BOOL("pre", struct run, pre, .fallback = "yes",
		.help = "whether a set-up is done before the run; no: there is none if nothing has changed "
			"since "
			"the last run"),
	TS_BOOL("post", struct run, post, .fallback = "yes", .help = "whether the timing summary is printed"),
	TS_BOOL("unsafe", struct run, unsafe, .fallback = "no",
		.help = "whether a time step beyond a stability limit is a warning instead of an error"),
	TS_REST_KEYWORD("every", struct run, pieces,
			.help = "M and commands in quotes: interrupt the run every M steps to execute them"),
	TS_ARGS_END,
};

static const struct ts_arg_group groups[] = {
	{ NULL, "N upto every" },
	{ "Several runs as one", "start stop" },
	{ "Preparation and end", "pre post unsafe" },
	{ .words = NULL },
};

TS_STYLE(command, ts_command_style, ts_command_run)
const struct ts_command_style ts_command_run = {
	.style = { .name = "run",
		   .kind = TS_KIND_COMMAND,
		   .summary = "Runs the simulation for N steps",
		   .doc = "Plans the run (see -explain), checks the time step against the stability limits "
			  "of all styles, and runs N steps. Forces are recomputed at its start only if "
			  "something they depend on has changed since the last step, so that a run cut into "
			  "several gives the same results, bit for bit. Some commands count as a change "
			  "even if no force depends on them: group, and definitions of fixes that store "
			  "numbers of particles or act in steps, such as property/atom, store/force and "
			  "massflow/mesh.\n\n"
			  "`every M \"command\" ...` interrupts the run every M steps to execute the "
			  "commands; variables in them are substituted each time. Before the first step "
			  "they are checked, including those of `if`: commands, styles, arguments and "
			  "variables must exist.\n\n"
			  "Of a number of steps with a fraction, such as a time divided by the time step, "
			  "the whole part is taken, with a warning.\n\n"
			  "Quantities that change over a run, such as ramp(), change from its first to its "
			  "last step. With `start` and `stop` several runs, or a run and its continuation "
			  "from a restart file, count as one.\n\n"
			  "A time step beyond a stability limit is an error. During the run the limits are "
			  "evaluated again, since stiffnesses, masses and velocities change: from 80 % of a "
			  "limit on there is a warning, once for each cause, and a run that stays beyond a "
			  "limit is stopped with a message about the cause, its location and a sufficiently "
			  "small time step (doc/stability.md; thermo keyword stable_fraction). `unsafe yes` "
			  "turns these errors into warnings; it is meant for tests of the limits.",
		   .example = "run 20000\nrun 100000 upto\nrun 5000 every 1000 \"print 'step $(step)'\"",
		   .args = args,
		   .groups = groups,
		   .ranks = TS_RANKS_FORMULAS,
		   .state_size = sizeof(struct run) },
	.needs_box = true,
	.run = run,
};

struct run_time {
	double time;
	bool upto;
};

/* Number of steps that cover `span`; what a quotient lacks or exceeds by round-off is no step. */
static enum ts_status steps_of(struct tsim *sim, double span, const struct ts_place *where, int64_t *steps)
{
	const double n = span / sim->clock.dt, nearest = round(n);
	const double whole = fabs(n - nearest) <= 1e-9 * fmax(1, nearest) ? nearest : ceil(n);

	if (!(whole <= 9e15))
		return ts_fail(&sim->error, TS_RANGE, where, "run_time: %g steps of %g are out of range",
			       whole, sim->clock.dt);
	*steps = (int64_t)whole;
	return TS_OK;
}

static enum ts_status run_time(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct run_time *t = state;
	const double now = ts_sim_time(sim);
	double span = t->upto ? t->time - now : t->time;
	struct run r = { .start = -1, .stop = -1, .pre = true, .post = true };

	if (span < 0 && (span > -sim->clock.dt || sim->reading.open_clock)) /* the last step has covered it */
		span = 0;
	if (span < 0)
		return ts_fail(&sim->error, TS_RANGE, ts_sim_word(sim, 1, where),
			       "run_time upto %g: the simulation is already at time %g", t->time, now);
	TS_TRY(steps_of(sim, span, ts_sim_word(sim, 1, where), &r.steps));
	return run(sim, &r, where);
}

static const struct ts_arg time_args[] = {
	TS_REAL("T", struct run_time, time, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE, .unit = "time",
		.help = "time"),
	TS_FLAG("upto", struct run_time, upto, .help = "run until the time T instead of T longer"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_run_time)
const struct ts_command_style ts_command_run_time = {
	.style = { .name = "run_time",
		   .kind = TS_KIND_COMMAND,
		   .summary = "Runs the simulation for a time",
		   .doc = "As `run N` with the number of steps that cover the time T: T divided by the time "
			  "step, a fraction of a step counts as one. A quotient that is whole but for "
			  "round-off, a part in 1e9, is taken as whole.",
		   .example = "run_time 0.5\nrun_time 2.0 upto",
		   .args = time_args,
		   .ranks = TS_RANKS_FORMULAS,
		   .state_size = sizeof(struct run_time) },
	.needs_box = true,
	.run = run_time,
};
