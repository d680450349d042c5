/* The set-up of a run.
 *
 * The contact list is always rebuilt; forces are computed only if something they depend on has changed
 * since the last step. So a run cut in two, in one script or by a restart file, gives the results of the
 * whole run.
 *
 * With several ranks each makes the lists and forces of its own particles, as in a step. Before, all look at all particles,
 * and afterwards each at its own contacts, for what the review or the limits of the time step would say. If there is
 * anything, or something reads lists of all contacts before the first step, all ranks do the set-up of one. */
#include "core/plan.h"

#include "core/fingerprint.h"
#include "core/ranks.h"
#include "core/recorder.h"

#include "base/banned.h"

static int64_t steps_to_go(const struct tsim *sim)
{
	return sim->clock.last_step - sim->clock.step;
}

/* Whether all ranks do the first step with all particles. */
static bool first_step_is_whole(struct tsim *sim)
{
	const int64_t now = sim->clock.step;
	bool is;

	sim->clock.step = now + 1;
	is = ts_ranks_step_due(sim);
	sim->clock.step = now;
	return is;
}

/* The plan of the whole run is a part of its report. */
static bool is_recorded(const struct tsim *sim)
{
	return sim->recorder && sim->recorder->records(sim->recorder);
}

/* Whether the last run has left the particles divided, or a look at them. */
static bool is_apart(const struct tsim *sim)
{
	return sim->run.looks || sim->division;
}

static enum ts_status can_keep_own(const struct ts_plan *plan, struct tsim *sim, bool *can)
{
	*can = ts_ranks(sim) > 1 && steps_to_go(sim) > 0 && sim->dimension == 3 && !sim->reading.explain &&
	       !is_recorded(sim) && !(sim->run.resuming && sim->run.shows_contacts && !is_apart(sim)) &&
	       !first_step_is_whole(sim) && !ts_ranks_set_up_whole(plan, sim);
	if (!*can)
		return TS_OK;
	sim->review.found = false;
	TS_TRY(ts_review_search(sim, steps_to_go(sim), false));
	*can = !(ts_ranks_most(sim, sim->review.found) > 0);
	return TS_OK;
}

/* Makes the lists of the particles of this rank; *done: nothing is to be said of them. */
static enum ts_status make_own_lists(struct ts_plan *plan, struct tsim *sim, bool *done)
{
	const bool was_apart = sim->division;

	if (!was_apart)
		TS_TRY(sim->tables->keep_own(sim));
	TS_TRY(ts_plan_stages(plan, sim, TS_STAGE_BUILD, TS_STAGE_POST_BUILD));
	if (was_apart) /* before the exchange */
		TS_TRY(ts_review_search(sim, steps_to_go(sim), false));
	TS_TRY(ts_review_search(sim, steps_to_go(sim), true));
	TS_TRY(sim->tables->judge_own(sim));
	*done = !(ts_ranks_most(sim, sim->review.found) > 0);
	return TS_OK;
}

static enum ts_status compute_forces(struct ts_plan *plan, struct tsim *sim)
{
	sim->run.in_setup = true;
	TS_TRY(ts_plan_stages(plan, sim, TS_STAGE_PRE_FORCE, TS_STAGE_POST_FORCE));
	sim->run.in_setup = false;
	return TS_OK;
}

/* The set-up of each rank by itself; *done: false: all ranks have all particles and lists, but no forces. */
static enum ts_status set_up_own(struct ts_plan *plan, struct tsim *sim, bool *done)
{
	bool resuming = sim->run.resuming;

	TS_TRY(make_own_lists(plan, sim, done));
	if (*done && !resuming)
		TS_TRY(compute_forces(plan, sim));
	sim->run.resuming = resuming; /* the sums of the last step are known */
	if (!*done || ts_ranks_first_look(plan, sim))
		TS_TRY(sim->tables->gather(plan, sim, !*done));
	else
		TS_TRY(ts_ranks_tell(sim));
	sim->run.resuming = resuming;
	sim->review.made |= *done;
	return TS_OK;
}

enum ts_status ts_plan_is_unchanged(struct tsim *sim, bool *unchanged)
{
	bool differs;
	double changed;

	TS_TRY(ts_fingerprint_differs(sim, sim->run.fingerprint, &differs));
	changed = differs;
	if (is_apart(sim)) /* each rank has hashed its own particles */
		ts_world_most(sim->world, &changed, 1);
	*unchanged = !(changed > 0);
	return TS_OK;
}

/* Whether the run goes on with the forces of the last step. */
static enum ts_status find_resuming(struct tsim *sim)
{
	bool unchanged;

	TS_TRY(ts_plan_is_unchanged(sim, &unchanged));
	sim->run.resuming = unchanged && !sim->legacy;
	return TS_OK;
}

/* What the last run has left divided stays so if each rank can do the set-up by itself, and else is gathered. */
static enum ts_status begin_apart(struct ts_plan *plan, struct tsim *sim, bool *tried)
{
	TS_TRY(can_keep_own(plan, sim, tried));
	if (!*tried)
		return ts_plan_have_all(plan, sim);
	return sim->run.looks ? sim->tables->divide(plan, sim) : TS_OK;
}

enum ts_status ts_plan_set_up(struct ts_plan *plan, struct tsim *sim)
{
	bool tried = false, done = false;

	/* Styles whose init has failed can neither act nor be judged. After the error of another line particles may be of any
	 * size and at any place, and lists of contacts take any memory. */
	if (sim->reading.faults != plan->faults || sim->reading.broken)
		return TS_OK;
	TS_TRY(find_resuming(sim));
	if (is_apart(sim))
		TS_TRY(begin_apart(plan, sim, &tried));
	if (!sim->run.resuming)
		TS_TRY(ts_plan_stage(plan, sim, TS_STAGE_EXCHANGE));
	if (!is_apart(sim))
		TS_TRY(can_keep_own(plan, sim, &tried));
	if (tried)
		TS_TRY(set_up_own(plan, sim, &done));
	if (done)
		return ts_plan_first_forces(plan, sim, false);
	if (!tried)
		TS_TRY(ts_plan_stages(plan, sim, TS_STAGE_BUILD, TS_STAGE_POST_BUILD));
	TS_TRY(ts_review_scene(sim, steps_to_go(sim)));
	TS_TRY(sim->tables->judge(plan, sim, steps_to_go(sim)));
	if (sim->reading.explain)
		return TS_OK;
	return ts_plan_first_forces(plan, sim, !sim->run.resuming);
}

enum ts_status ts_plan_first_forces(struct ts_plan *plan, struct tsim *sim, bool anew)
{
	if (anew)
		TS_TRY(compute_forces(plan, sim));
	sim->run.resuming = false;
	return ts_plan_stage(plan, sim, TS_STAGE_SETUP);
}
