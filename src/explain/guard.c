/* Checks are made after the first step, 128 steps later, then at intervals that double up to 4096 steps,
 * but are no longer than the time to reach the limit at the rate of change of the last interval; they take
 * less than 0.5 % of the run time. Advised values are evaluated at the first check and at the longest
 * interval only.
 *
 * Beyond the limit h_max of the time step h an oscillation grows by about |z| = 1 + 2 sqrt(2 (h/h_max - 1))
 * per step. A collision that lasts one or two steps does not grow noticeably, and a starting flow slows
 * down: a run is stopped only if the limit is exceeded at four of nine successive steps. */
#include "explain/guard.h"

#include <inttypes.h>
#include <math.h>

#include "core/ranks.h"
#include "core/value.h"

#include "base/banned.h"

/* Shortest and longest interval of checks; steps checked in a row beyond a limit, and how many stop the
 * run. */
enum { FIRST = 128, LONGEST = 4096, WINDOW = 8, ENOUGH = 4 };
enum level { NEAR = 1, BEYOND = 2 };
static const double NEAR_FROM = 0.8; /* fraction of a limit that is NEAR */

/* Records a warning of this level for the cause of the limit; TS_STATE: it was given before. */
static enum ts_status record_warning(struct ts_told *warned, const struct ts_limit *limit, enum level level)
{
	int64_t key = (int64_t)(limit->cause & ~(uint64_t)3);

	for (int k = 0; k < warned->n; k++)
		if ((warned->cause[k] & ~(int64_t)3) == key) {
			if ((warned->cause[k] & 3) >= (int64_t)level)
				return TS_STATE;
			warned->cause[k] = key | (int64_t)level;
			return TS_OK;
		}
	if (warned->n == TS_TOLD)
		return TS_STATE;
	warned->cause[warned->n++] = key | (int64_t)level;
	return TS_OK;
}

/* A new time step: all warnings may be given again. */
static void reset_if_new_dt(struct ts_guard *g, const struct tsim *sim)
{
	if (g->dt == sim->clock.dt)
		return;
	g->dt = sim->clock.dt;
	g->fraction = 0;
	g->next = 0;
	g->seen = 0;
	g->told.n = g->heard.n = 0;
}

/* ---- at the start of a run ---- */

static void warn_beyond(struct tsim *sim, const struct ts_limit *limit)
{
	if (!(limit->dt > 0)) {
		ts_warn(&sim->log, &limit->where, "perhaps no time step is stable with %s", limit->text);
		return;
	}
	ts_warn(&sim->log, &limit->where,
		limit->fatal ? "the time step %g exceeds the stability limit %g of %s"
			     : "the time step %g exceeds the recommended limit %g of %s",
		sim->clock.dt, limit->dt, limit->text);
}

static void warn_near(struct tsim *sim, const struct ts_limit *limit)
{
	ts_warn(&sim->log, &limit->where, "the time step %g is %.0f %% of the stability limit %g of %s",
		sim->clock.dt, 100 * sim->clock.dt / limit->dt, limit->dt, limit->text);
}

/* Level of the time step with respect to a limit; 0: well below it. */
static int level_of(const struct tsim *sim, const struct ts_limit *limit)
{
	if (!(sim->clock.dt < limit->dt))
		return BEYOND;
	return limit->fatal && sim->clock.dt >= NEAR_FROM * limit->dt ? NEAR : 0;
}

static bool was_told(const struct ts_guard *g, const struct ts_limit *limit, enum level level)
{
	struct ts_told copy = g->told;

	return record_warning(&copy, limit, level) != TS_OK;
}

enum ts_status ts_guard_judge(struct tsim *sim, const struct ts_plan_report *report)
{
	struct ts_guard *g = sim->guard;
	const struct ts_limit *hard = ts_report_binding(report, true);
	const struct ts_limit *soft = ts_report_binding(report, false);

	reset_if_new_dt(g, sim);
	if (hard && level_of(sim, hard) == BEYOND && !sim->run.unsafe)
		return ts_fail(&sim->error, TS_PHYSICS, &hard->where,
			       "the time step %g exceeds the stability limit %g of %s; use a smaller "
			       "`timestep`, at most a tenth of the limit for accuracy",
			       sim->clock.dt, hard->dt, hard->text);
	for (int k = 0; k < 2; k++) {
		const struct ts_limit *limit = k ? soft : hard;
		int level = limit ? level_of(sim, limit) : 0;

		if (!level || was_told(g, limit, level) || record_warning(&g->heard, limit, level) != TS_OK)
			continue;
		(level == BEYOND ? warn_beyond : warn_near)(sim, limit);
	}
	return TS_OK;
}

/* ---- during a run ---- */

static enum ts_status stop_run(struct tsim *sim, const struct ts_limit *hard)
{
	return ts_fail(&sim->error, TS_PHYSICS, &hard->where,
		       "at step %" PRId64
		       " the time step %g exceeds the stability limit %g of %s; use `timestep %.2g` (a tenth "
		       "of the limit) or at least less than the limit",
		       sim->clock.step, sim->clock.dt, hard->dt, hard->text, 0.1 * hard->dt);
}

/* Warns once for each cause, unless the start of this run has given the warning. */
static void warn_once(struct tsim *sim, const struct ts_limit *limit, int level)
{
	struct ts_guard *g = sim->guard;

	if (record_warning(&g->told, limit, level) != TS_OK ||
	    record_warning(&g->heard, limit, level) != TS_OK)
		return;
	if (!(limit->dt > 0)) {
		ts_warn(&sim->log, &limit->where,
			"at step %" PRId64 " perhaps no time step is stable with %s", sim->clock.step,
			limit->text);
		return;
	}
	ts_warn(&sim->log, &limit->where, "at step %" PRId64 " the time step %g is %.0f %% of %s%g of %s",
		sim->clock.step, sim->clock.dt, 100 * sim->clock.dt / limit->dt,
		limit->fatal ? "the stability limit " : "", limit->dt, limit->text);
}

static enum ts_status judge_hard(struct tsim *sim, const struct ts_limit *hard)
{
	struct ts_guard *g = sim->guard;
	int level = level_of(sim, hard);

	if (hard->watched)
		level = level ? NEAR : 0;
	if (level == BEYOND && !g->seen++)
		g->until = sim->clock.step + WINDOW;
	if (level == BEYOND && g->seen >= ENOUGH && !sim->run.unsafe)
		return stop_run(sim, hard);
	if (level == BEYOND && sim->run.unsafe)
		warn_once(sim, hard, BEYOND);
	else if (level)
		warn_once(sim, hard, NEAR);
	return TS_OK;
}

static void choose_next(struct ts_guard *g, int64_t step, double fraction)
{
	double rate = (fraction - g->fraction) / (double)g->interval;
	double ahead = ((fraction < NEAR_FROM ? NEAR_FROM : 1) - fraction) / rate;

	g->fraction = fraction;
	if (g->seen && step < g->until) {
		g->next = step + 1;
		return;
	}
	g->seen = 0;
	g->interval = 2 * g->interval < LONGEST ? 2 * g->interval : LONGEST;
	if (rate > 0 && ahead < (double)g->interval)
		g->interval = ahead > FIRST ? (int64_t)ahead : FIRST;
	g->next = step + g->interval;
}

static enum ts_status check_limits(struct tsim *sim, const struct ts_plan_report *report)
{
	struct ts_guard *g = sim->guard;
	const struct ts_limit *hard = ts_report_binding(report, true);

	if (hard)
		TS_TRY(judge_hard(sim, hard));
	for (size_t k = 0; k < report->nlimits; k++)
		if (!report->limit[k].fatal && level_of(sim, &report->limit[k]) == BEYOND)
			warn_once(sim, &report->limit[k], BEYOND);
	choose_next(g, sim->clock.step, hard ? sim->clock.dt / hard->dt : 0);
	return TS_OK;
}

double ts_guard_enough(const struct tsim *sim)
{
	return sim->clock.dt / NEAR_FROM;
}

static enum ts_status evaluate_limits(struct tsim *sim, double enough, bool advice,
				      struct ts_plan_report *report)
{
	*report = (struct ts_plan_report){ .limits_only = true, .advice = advice, .enough = enough };
	return ts_report_collect(report, sim);
}

static bool is_due(const struct ts_guard *g, const struct tsim *sim)
{
	/* reset_timestep may have set the step back */
	return !g->next || g->next > sim->clock.step + LONGEST || sim->clock.step >= g->next;
}

static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	return is_due(self->state, sim);
}

typedef enum ts_status check_fn(struct tsim *sim, const struct ts_plan_report *report);

static enum ts_status check_if_due(struct ts_guard *g, struct tsim *sim, check_fn *check)
{
	struct ts_plan_report report;
	enum ts_status status;

	if (!g->next || g->next > sim->clock.step + LONGEST) { /* reset_timestep may have set the step back */
		g->interval = FIRST / 2;
		g->next = sim->clock.step;
	}
	if (sim->clock.step < g->next)
		return TS_OK;
	ts_deferred_loops_run(sim);
	status = evaluate_limits(sim, ts_guard_enough(sim),
				 g->interval == FIRST / 2 || g->interval == LONGEST, &report);
	if (status == TS_OK)
		status = check(sim, &report);
	ts_report_release(&report);
	return status;
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	return check_if_due(self->state, sim, check_limits);
}

/* Whether a check of these limits would say or end anything. */
static bool has_consequences(const struct tsim *sim, const struct ts_plan_report *report,
			     const struct ts_limit *hard)
{
	const struct ts_guard *g = sim->guard;
	int level = hard ? level_of(sim, hard) : 0;

	if (g->seen || (level == BEYOND && !hard->watched) || (level && !was_told(g, hard, NEAR)))
		return true;
	for (size_t k = 0; k < report->nlimits; k++)
		if (!report->limit[k].fatal && level_of(sim, &report->limit[k]) == BEYOND &&
		    !was_told(g, &report->limit[k], BEYOND))
			return true;
	return false;
}

bool ts_guard_has_doubts(struct tsim *sim, const struct ts_plan_report *report)
{
	reset_if_new_dt(sim->guard, sim);
	return report->undecided || has_consequences(sim, report, ts_report_binding(report, true));
}

/* Each rank has the limits of its own particles; the least one of all ranks is that which one rank would find. */
static enum ts_status check_own_limits(struct tsim *sim, const struct ts_plan_report *report)
{
	const struct ts_limit *hard = ts_report_binding(report, true);
	double most[2] = { report->undecided || has_consequences(sim, report, hard),
			   hard ? -hard->dt : -INFINITY };

	ts_ranks_most_of(sim, most, 2);
	if (!(most[0] > 0)) /* else all ranks check all particles */
		choose_next(sim->guard, sim->clock.step, sim->clock.dt / -most[1]);
	return TS_OK;
}

static enum ts_status settle(struct ts_instance *self, struct tsim *sim)
{
	return check_if_due(self->state, sim, check_own_limits);
}

/* ---- for outputs ---- */

static enum ts_status stable_fraction(struct tsim *sim, double *out)
{
	struct ts_plan_report report;
	const struct ts_limit *hard;
	enum ts_status status;

	*out = sim->guard->fraction;
	if (!sim->run.inside)
		return TS_OK;
	status = evaluate_limits(sim, INFINITY, false, &report);
	hard = ts_report_binding(&report, true);
	*out = hard ? sim->clock.dt / hard->dt : 0;
	ts_report_release(&report);
	return status;
}

static const struct ts_keyword keywords[] = {
	{ "stable_fraction", "StabFrac", "",
	  "time step divided by the smallest current stability limit; outside of runs, that of the last "
	  "check",
	  TS_KEYWORD_LISTS, stable_fraction },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct ts_guard, dt),
	TS_SAVE_F64(struct ts_guard, fraction),
	TS_SAVE_I64(struct ts_guard, next),
	TS_SAVE_I64(struct ts_guard, interval),
	TS_SAVE_I64(struct ts_guard, until),
	TS_SAVE_I32(struct ts_guard, seen),
	TS_SAVE_I64(struct ts_guard, told.cause),
	TS_SAVE_I32(struct ts_guard, told.n),
	TS_SAVED_ROWS_END,
};

const struct ts_system_style ts_guard_system = {
	.style = { .name = "guard",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "checks that the time step stays below the stability limits",
		   .state_size = sizeof(struct ts_guard),
		   .saved = saved,
		   .hook = { [TS_STAGE_END_OF_STEP] = end_of_step },
		   .ranks = TS_RANKS_WHOLE,
		   .due = due,
		   .settle = settle,
		   .defers = TS_DEFERS(END_OF_STEP) },
	.slot = offsetof(struct tsim, guard),
	.keywords = keywords,
};
