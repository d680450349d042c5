/* Looks come after the first step, 128 steps later, then at intervals that double, up to 4096 steps, but
 * are no longer than it would take to come near the limit at the rate of the last interval: together they
 * cost less than half a per cent. What is only advice is asked for at the first look and at the rarest.
 *
 * Beyond a limit a mode z grows by |z| = 1 + 2 sqrt(2 (h/h_max - 1)) or so in every step, but a collision
 * that is over in a step or two has no time for it, and a flow that starts slows down: a run is stopped
 * only if it is beyond at four of nine successive steps. */
#include "explain/guard.h"

#include <inttypes.h>
#include <math.h>

#include "core/value.h"

#include "base/banned.h"

enum { FIRST = 128, LONGEST = 4096, WINDOW = 8, ENOUGH = 4 };
enum level { NEAR = 1, BEYOND = 2 };
static const double NEAR_FROM = 0.8;

static enum ts_status note(struct ts_told *told, const struct ts_limit *limit, enum level level)
{
	int64_t key = (int64_t)(limit->cause & ~(uint64_t)3);

	for (int k = 0; k < told->n; k++)
		if ((told->cause[k] & ~(int64_t)3) == key) {
			if ((told->cause[k] & 3) >= (int64_t)level)
				return TS_STATE;
			told->cause[k] = key | (int64_t)level;
			return TS_OK;
		}
	if (told->n == TS_TOLD)
		return TS_STATE;
	told->cause[told->n++] = key | (int64_t)level;
	return TS_OK;
}

/* A new time step: nothing has been said of it. */
static void begin(struct ts_guard *g, const struct tsim *sim)
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
	ts_warn(&sim->log, &limit->where,
		limit->fatal ? "the time step %g is beyond the stability limit %g of %s"
			     : "the time step %g is larger than %g, the limit of %s",
		sim->clock.dt, limit->dt, limit->text);
}

static void warn_near(struct tsim *sim, const struct ts_limit *limit)
{
	ts_warn(&sim->log, &limit->where, "the time step %g is %.0f %% of the stability limit %g of %s",
		sim->clock.dt, 100 * sim->clock.dt / limit->dt, limit->dt, limit->text);
}

/* How the time step stands to a limit; 0: well. */
static int level_of(const struct tsim *sim, const struct ts_limit *limit)
{
	if (!(sim->clock.dt < limit->dt))
		return BEYOND;
	return limit->fatal && sim->clock.dt >= NEAR_FROM * limit->dt ? NEAR : 0;
}

static bool told(const struct ts_guard *g, const struct ts_limit *limit, enum level level)
{
	struct ts_told copy = g->told;

	return note(&copy, limit, level) != TS_OK;
}

enum ts_status ts_guard_judge(struct tsim *sim, const struct ts_plan_report *report)
{
	struct ts_guard *g = sim->guard;
	const struct ts_limit *hard = ts_report_binding(report, true);
	const struct ts_limit *soft = ts_report_binding(report, false);

	begin(g, sim);
	if (hard && level_of(sim, hard) == BEYOND && !sim->run.unsafe)
		return ts_fail(&sim->error, TS_PHYSICS, &hard->where,
			       "the time step %g is beyond the stability limit %g of %s; "
			       "use `timestep` with less than that, a tenth or less for accuracy",
			       sim->clock.dt, hard->dt, hard->text);
	for (int k = 0; k < 2; k++) {
		const struct ts_limit *limit = k ? soft : hard;
		int level = limit ? level_of(sim, limit) : 0;

		if (!level || told(g, limit, level) || note(&g->heard, limit, level) != TS_OK)
			continue;
		(level == BEYOND ? warn_beyond : warn_near)(sim, limit);
	}
	return TS_OK;
}

/* ---- while it steps ---- */

static enum ts_status stop(struct tsim *sim, const struct ts_limit *hard)
{
	return ts_fail(&sim->error, TS_PHYSICS, &hard->where,
		       "at step %" PRId64 " the time step %g is beyond the stability limit %g of %s; use "
		       "`timestep %.2g` (a tenth of the limit) or at least less than the limit",
		       sim->clock.step, sim->clock.dt, hard->dt, hard->text, 0.1 * hard->dt);
}

/* Once of each cause, and not what the start of this run has said already. */
static void say(struct tsim *sim, const struct ts_limit *limit, int level)
{
	struct ts_guard *g = sim->guard;

	if (note(&g->told, limit, level) != TS_OK || note(&g->heard, limit, level) != TS_OK)
		return;
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
		return stop(sim, hard);
	if (level == BEYOND && sim->run.unsafe)
		say(sim, hard, BEYOND);
	else if (level)
		say(sim, hard, NEAR);
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

static enum ts_status look(struct tsim *sim, const struct ts_plan_report *report)
{
	struct ts_guard *g = sim->guard;
	const struct ts_limit *hard = ts_report_binding(report, true);

	if (hard)
		TS_TRY(judge_hard(sim, hard));
	for (size_t k = 0; k < report->nlimits; k++)
		if (!report->limit[k].fatal && level_of(sim, &report->limit[k]) == BEYOND)
			say(sim, &report->limit[k], BEYOND);
	choose_next(g, sim->clock.step, hard ? sim->clock.dt / hard->dt : 0);
	return TS_OK;
}

double ts_guard_enough(const struct tsim *sim)
{
	return sim->clock.dt / NEAR_FROM;
}

static enum ts_status limits_now(struct tsim *sim, double enough, bool advice, struct ts_plan_report *report)
{
	*report = (struct ts_plan_report){ .limits_only = true, .advice = advice, .enough = enough };
	return ts_report_collect(report, sim);
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	struct ts_guard *g = self->state;
	struct ts_plan_report report;
	enum ts_status status;

	if (!g->next || g->next > sim->clock.step + LONGEST) { /* steps may be counted anew */
		g->interval = FIRST / 2;
		g->next = sim->clock.step;
	}
	if (sim->clock.step < g->next)
		return TS_OK;
	ts_run_deferred_loops(sim);
	status = limits_now(sim, ts_guard_enough(sim), g->interval == FIRST / 2 || g->interval == LONGEST,
			    &report);
	if (status == TS_OK)
		status = look(sim, &report);
	ts_report_release(&report);
	return status;
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
	status = limits_now(sim, INFINITY, false, &report);
	hard = ts_report_binding(&report, true);
	*out = hard ? sim->clock.dt / hard->dt : 0;
	ts_report_release(&report);
	return status;
}

static const struct ts_keyword keywords[] = {
	{ "stable_fraction", "StabFrac", "",
	  "time step by the smallest limit of stability there is now; outside of runs, at the guard's last "
	  "look",
	  0, stable_fraction },
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
		   .summary = "looks whether the time step stays below the limits of stability",
		   .state_size = sizeof(struct ts_guard),
		   .saved = saved,
		   .hook = { [TS_STAGE_END_OF_STEP] = end_of_step },
		   .defers = TS_DEFERS(END_OF_STEP) },
	.slot = offsetof(struct tsim, guard),
	.keywords = keywords,
};
