/* The steps of a run, its begin and its end. */
#include "core/plan.h"

#include <inttypes.h>

#include "base/clock.h"
#include "core/fingerprint.h"
#include "core/ranks.h"
#include "core/saver.h"
#include "core/settings.h"

#include "base/banned.h"

/* After the last step. */
static enum ts_status have_end(struct ts_plan *plan, struct tsim *sim)
{
	if (!ts_ranks_may_pause(plan, sim))
		return ts_plan_have_all(plan, sim);
	if (sim->division && ts_ranks_may_rest(plan, sim))
		return sim->tables->rest(sim, true);
	return sim->division ? sim->tables->gather(plan, sim, false) : TS_OK;
}

/* Particles are divided among ranks in all steps that need not be done with all particles. */
static enum ts_status divide_or_gather(struct ts_plan *plan, struct tsim *sim)
{
	if (ts_ranks_step_due(sim))
		return ts_plan_have_all(plan, sim);
	return sim->division ? TS_OK : sim->tables->divide(plan, sim);
}

/* Velocity Verlet; the order of stages is that of LIGGGHTS. */
enum ts_status ts_plan_step(struct ts_plan *plan, struct tsim *sim)
{
	sim->clock.step++;
	if (sim->world)
		TS_TRY(divide_or_gather(plan, sim));
	TS_TRY(ts_plan_stages_deferring(plan, sim, TS_STAGE_INITIAL_INTEGRATE, TS_STAGE_CHECK));
	if (sim->world)
		ts_ranks_agree(sim);
	sim->run.rebuild |= (sim->full & TS_FULL_REBUILDS) != 0;
	sim->run.relist &= !sim->run.rebuild;
	sim->run.rebuild |= sim->run.relist;
	plan->rebuilds += sim->run.rebuild;
	if (sim->run.rebuild)
		TS_TRY(ts_plan_stages_deferring(plan, sim, TS_STAGE_PRE_EXCHANGE, TS_STAGE_POST_BUILD));
	else
		TS_TRY(ts_plan_stages_deferring(plan, sim, TS_STAGE_FORWARD, TS_STAGE_FORWARD));
	sim->run.rebuild = sim->run.relist = sim->run.runaways = false;
	TS_TRY(ts_plan_stages_deferring(plan, sim, TS_STAGE_PRE_FORCE, TS_STAGE_FINAL_INTEGRATE));
	if (sim->division)
		TS_TRY(ts_ranks_settle(plan, sim));
	if (sim->division && ts_ranks_whole_due(plan, sim))
		TS_TRY(sim->tables->gather(plan, sim, ts_ranks_lists_due(plan, sim)));
	return ts_plan_stages_deferring(plan, sim, TS_STAGE_END_OF_STEP, TS_STAGE_OUTPUT);
}

/* Resets the flags that are valid only inside a run. */
static enum ts_status leave_run(struct tsim *sim, enum ts_status status)
{
	ts_deferred_loops_run(sim);
	sim->run.inside = sim->run.in_setup = sim->run.resuming = sim->run.rebuild = sim->run.relist =
		sim->run.runaways = sim->requests.saving = false;
	return status;
}

enum ts_status ts_plan_start(struct ts_plan *plan, struct tsim *sim, bool setup)
{
	enum ts_status status;
	bool unchanged = false;

	ts_settings_log_run(sim);
	sim->run.inside = true;
	sim->run.force_ticks = 0;
	plan->watch.last = ts_ticks();
	sim->clock.wall_start = ts_clock();
	status = sim->division ? sim->tables->rest(sim, false) : TS_OK;
	if (status == TS_OK && !setup && !sim->reading.explain)
		status = ts_plan_is_unchanged(sim, &unchanged);
	if (status == TS_OK && !unchanged)
		status = ts_plan_set_up(plan, sim);
	else if (status == TS_OK && sim->division && ts_ranks_output_due(plan, sim))
		status = sim->tables->gather(plan, sim, false);
	if (sim->reading.explain)
		sim->clock.step = sim->clock.last_step;
	else if (status == TS_OK) /* after SETUP, in which fixes evaluate the initial state */
		status = ts_plan_stage(plan, sim, TS_STAGE_OUTPUT);
	return leave_run(sim, status);
}

/* timer timeout: the run ends with this step, later ones do nothing. Several ranks have agreed on it in the step. */
static void check_timeout(struct tsim *sim)
{
	if (!(sim->world ? sim->run.timed_out : ts_sim_time_is_up(sim)))
		return;
	sim->run.timed_out = false;
	ts_log(&sim->log, "Wall time limit reached at step %" PRId64 "\n", sim->clock.step);
	sim->clock.last_step = sim->clock.step;
	sim->run.halted = true;
}

enum ts_status ts_plan_steps(struct ts_plan *plan, struct tsim *sim)
{
	enum ts_status status = TS_OK;

	sim->run.inside = true;
	plan->watch.last = ts_ticks();
	while (status == TS_OK && sim->clock.step < sim->clock.last_step) {
		if (sim->requests.stop && sim->run.complete)
			break;
		if (sim->requests.stop) /* one more step, which is known to be the last: outputs write it */
			sim->clock.last_step = sim->clock.step + 1;
		sim->requests.saving = sim->requests.save && sim->requests.saver;
		status = ts_plan_step(plan, sim);
		if (status == TS_OK && sim->requests.saving)
			status = ts_saver_save(sim);
		if (status == TS_OK && sim->recorder)
			sim->recorder->step(sim->recorder, sim);
		check_timeout(sim);
	}
	if (status == TS_OK)
		status = have_end(plan, sim);
	status = leave_run(sim, status);
	if (sim->recorder)
		sim->recorder->stop(sim->recorder, sim, plan);
	return status;
}

enum ts_status ts_plan_finish(struct ts_plan *plan, struct tsim *sim)
{
	sim->run.inside = true;
	plan->watch.last = ts_ticks();
	return leave_run(sim, ts_plan_stage(plan, sim, TS_STAGE_FINISH));
}

enum ts_status ts_plan_stopped(struct tsim *sim)
{
	sim->requests.stopped_whole = sim->requests.stop != 0;
	if (sim->requests.stop)
		return ts_fail(&sim->error, TS_STOPPED, NULL,
			       "stopped on request after step %" PRId64
			       "; all results up to here are written",
			       sim->clock.step);
	return TS_OK;
}

enum ts_status ts_plan_run(struct ts_plan *plan, struct tsim *sim, bool setup)
{
	TS_TRY(ts_plan_start(plan, sim, setup));
	if (!sim->reading.explain) {
		TS_TRY(ts_plan_steps(plan, sim));
		TS_TRY(ts_plan_finish(plan, sim));
		TS_TRY(ts_fingerprint_renew(sim));
	}
	return ts_plan_stopped(sim);
}
