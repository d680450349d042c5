#include "core/plan.h"

#include <math.h>

#include "base/clock.h"
#include "core/ranks.h"
#include "core/ref_list.h"
#include "core/uses.h"
#include "core/written_files.h"

#include "base/banned.h"

/* The order of hooks in a stage. */
static const enum ts_kind kind_order[] = { TS_KIND_SYSTEM,   TS_KIND_PAIR,	TS_KIND_BOND,	TS_KIND_FLOW,
					   TS_KIND_PRESSURE, TS_KIND_AUTOMATON, TS_KIND_REGION, TS_KIND_FIX,
					   TS_KIND_COMPUTE,  TS_KIND_DUMP };
enum { NORDER = sizeof kind_order / sizeof *kind_order };

static enum ts_status append_action(struct ts_plan *plan, struct tsim *sim, struct ts_instance *inst,
				    int stage, ts_hook_fn *hook)
{
	bool usual = hook == inst->style->hook[stage], watches = hook == inst->style->watch;

	if (TS_GROW(plan->actions[stage], plan->capacity[stage], plan->n[stage] + 1) != TS_OK)
		return ts_nomem(&sim->error);
	plan->actions[stage][plan->n[stage]++] =
		(struct ts_action){ hook,
				    inst,
				    ts_instance_site(inst, stage),
				    watches,
				    usual && inst->style->defers >> stage & 1u,
				    !usual && !watches };
	return TS_OK;
}

static enum ts_status append_hooks(struct ts_plan *plan, struct tsim *sim, struct ts_instance *inst)
{
	for (int stage = 0; stage < TS_NSTAGE; stage++) {
		if (inst->style->hook[stage] && !(stage == TS_STAGE_OUTPUT && inst->style->saves_outputs))
			TS_TRY(append_action(plan, sim, inst, stage, inst->style->hook[stage]));
	}
	return TS_OK;
}

/* Restart files have what the other outputs of the step have left, wherever the script defines them. */
static enum ts_status append_savers(struct ts_plan *plan, struct tsim *sim)
{
	const struct ts_instances *list = &sim->instances[TS_KIND_DUMP];

	for (size_t k = 0; k < list->n; k++) {
		struct ts_instance *inst = list->item[k];

		if (inst->style->saves_outputs)
			TS_TRY(append_action(plan, sim, inst, TS_STAGE_OUTPUT,
					     inst->style->hook[TS_STAGE_OUTPUT]));
	}
	return TS_OK;
}

/* Hooks that need the sum of all forces, also those of the outside program. */
static enum ts_status append_late_hooks(struct ts_plan *plan, struct tsim *sim, int when)
{
	for (int k = 0; k < NORDER; k++) {
		const struct ts_instances *list = &sim->instances[kind_order[k]];

		for (size_t i = 0; i < list->n; i++) {
			struct ts_instance *inst = list->item[i];
			ts_hook_fn *hook = inst->style->late[when];

			if (!hook || (inst->style->is_late && !inst->style->is_late(inst)))
				continue;
			TS_TRY(append_action(plan, sim, inst, TS_STAGE_POST_FORCE, hook));
		}
	}
	return TS_OK;
}

/* Inserts the `watch` hook of this instance at the beginning of the stage and after each hook of another. */
static enum ts_status insert_watch_hooks(struct ts_plan *plan, struct tsim *sim, struct ts_instance *inst,
					 int stage)
{
	struct ts_action *before = plan->actions[stage];
	size_t n = plan->n[stage];
	enum ts_status status;

	plan->actions[stage] = NULL;
	plan->n[stage] = plan->capacity[stage] = 0;
	status = n ? append_action(plan, sim, inst, stage, inst->style->watch) : TS_OK;
	for (size_t k = 0; k < n && status == TS_OK; k++) {
		status = append_action(plan, sim, before[k].self, stage, before[k].hook);
		if (status == TS_OK && !before[k].watches && before[k].self != inst)
			status = append_action(plan, sim, inst, stage, inst->style->watch);
	}
	ts_free(before);
	return status;
}

static enum ts_status append_watch_hooks(struct ts_plan *plan, struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++)
		for (int stage = TS_STAGE_INITIAL_INTEGRATE;
		     fixes->item[k]->style->watch && stage <= TS_STAGE_END_OF_STEP; stage++)
			TS_TRY(insert_watch_hooks(plan, sim, fixes->item[k], stage));
	return TS_OK;
}

/* A region may be deleted while styles point to it, but no such style may remain in a run. */
static enum ts_status refuse_retired(struct tsim *sim)
{
	for (size_t k = 0; k < sim->retired.n; k++) {
		const struct ts_instance *region = sim->retired.item[k];
		const struct ts_instance *user = ts_uses_retired_region(sim, region);

		if (user)
			return ts_conflict(&sim->error, &user->where,
					   "%s %s uses region %s (%s:%d), which has been deleted since",
					   ts_kind_name(user->style->kind), user->id, region->id,
					   TS_FILE_AND_LINE(region->where));
	}
	return TS_OK;
}

enum ts_status ts_plan_compile(struct ts_plan *plan, struct tsim *sim)
{
	if (sim->recorder)
		TS_TRY(ts_sim_defer_error(sim, sim->recorder->begin(sim->recorder, sim)));
	for (int stage = 0; stage < TS_NSTAGE; stage++)
		plan->n[stage] = 0;
	plan->watch = (struct ts_stopwatch){ .first = ts_ticks(), .begin = ts_clock() };
	plan->faults = sim->reading.faults;
	ts_ranks_choose_steps(sim);
	sim->run.explicit_euler = sim->run.clamped = false; /* set by the init of integrators */
	TS_TRY(ts_sim_defer_error(sim, refuse_retired(sim)));
	for (int k = 0; k < NORDER; k++) {
		const struct ts_instances *list = &sim->instances[kind_order[k]];

		for (size_t i = 0; i < list->n; i++) {
			TS_TRY(ts_sim_defer_error(sim, ts_instance_init(list->item[i], sim)));
			TS_TRY(ts_sim_defer_error(sim, ts_refs_check(sim, list->item[i])));
			TS_TRY(append_hooks(plan, sim, list->item[i]));
		}
	}
	TS_TRY(append_savers(plan, sim));
	TS_TRY(ts_written_files_check(sim));
	if (sim->outside)
		TS_TRY(append_hooks(plan, sim, sim->outside));
	for (int when = 0; when < TS_NLATE; when++)
		TS_TRY(append_late_hooks(plan, sim, when));
	return append_watch_hooks(plan, sim);
}

void ts_plan_release(struct ts_plan *plan)
{
	for (int stage = 0; stage < TS_NSTAGE; stage++)
		ts_free(plan->actions[stage]);
	*plan = (struct ts_plan){ 0 };
}

/* Begins the epoch of a hook, in which cached outputs are valid. All hooks of OUTPUT share one epoch,
 * since they change nothing; the outside program may change anything, so that nothing is cached. */
static void begin_action(struct tsim *sim, const struct ts_action *action, enum ts_stage stage)
{
	sim->draws = (struct ts_draws){ action->site, 0 };
	if (action->self == sim->outside)
		sim->run.epoch = 0;
	else if (stage != TS_STAGE_OUTPUT || !sim->run.epoch)
		sim->run.epoch = ++sim->run.epochs;
}

/* Adds the time since the last reading to this stage, except that of deferred loops, which are mostly
 * integration and count as INITIAL_INTEGRATE. The clock is read only once in each stage, since steps of
 * few particles are short. */
static void read_stopwatch(struct ts_stopwatch *watch, struct tsim *sim, enum ts_stage stage)
{
	uint64_t now = ts_ticks();

	watch->spent[stage] += now - watch->last - sim->deferred.spent;
	watch->spent[TS_STAGE_INITIAL_INTEGRATE] += sim->deferred.spent;
	if (stage >= TS_STAGE_PRE_FORCE && stage <= TS_STAGE_POST_FORCE)
		sim->run.force_ticks += now - watch->last - sim->deferred.spent;
	watch->last = now;
	sim->deferred.spent = 0;
}

double ts_plan_seconds(const struct ts_plan *plan, enum ts_stage stage)
{
	const struct ts_stopwatch *watch = &plan->watch;
	double ticks = (double)(ts_ticks() - watch->first);

	return ticks > 0 ? (double)watch->spent[stage] / ticks * (ts_clock() - watch->begin) : 0;
}

static const struct {
	const char *name;
	enum ts_stage first, last;
} parts[TS_PLAN_PARTS] = {
	{ "Move", TS_STAGE_INITIAL_INTEGRATE, TS_STAGE_POST_INTEGRATE },
	{ "Neigh", TS_STAGE_CHECK, TS_STAGE_POST_BUILD },
	{ "Comm", TS_STAGE_FORWARD, TS_STAGE_FORWARD },
	{ "Force", TS_STAGE_PRE_FORCE, TS_STAGE_FORCE },
	{ "Fixes", TS_STAGE_POST_FORCE, TS_STAGE_END_OF_STEP },
	{ "Outpt", TS_STAGE_OUTPUT, TS_STAGE_FINISH },
};

const char *ts_plan_part_name(int part)
{
	return parts[part].name;
}

double ts_plan_part_seconds(const struct ts_plan *plan, int part)
{
	double seconds = 0;

	for (int s = (int)parts[part].first; s <= (int)parts[part].last; s++)
		seconds += ts_plan_seconds(plan, (enum ts_stage)s);
	return seconds;
}

static enum ts_status run_stage(struct ts_plan *plan, struct tsim *sim, enum ts_stage stage)
{
	enum ts_status status = TS_OK;

	if (!plan->n[stage])
		return TS_OK;
	sim->acted = (struct ts_acted){ NULL, (int)stage };
	for (size_t k = 0; k < plan->n[stage] && status == TS_OK; k++) {
		const struct ts_action *action = &plan->actions[stage][k];

		if (!action->defers)
			ts_deferred_loops_run(sim);
		begin_action(sim, action, stage);
		status = action->hook(action->self, sim);
		if (!action->watches)
			sim->acted.self = action->self;
	}
	sim->draws = (struct ts_draws){ 0 };
	sim->run.epoch = 0;
	read_stopwatch(&plan->watch, sim, stage);
	return status;
}

enum ts_status ts_plan_stages_deferring(struct ts_plan *plan, struct tsim *sim, enum ts_stage first,
					enum ts_stage last)
{
	for (int stage = (int)first; stage <= (int)last; stage++)
		TS_TRY(run_stage(plan, sim, (enum ts_stage)stage));
	return TS_OK;
}

enum ts_status ts_plan_stage(struct ts_plan *plan, struct tsim *sim, enum ts_stage stage)
{
	return ts_plan_stages(plan, sim, stage, stage);
}

enum ts_status ts_plan_stages(struct ts_plan *plan, struct tsim *sim, enum ts_stage first, enum ts_stage last)
{
	enum ts_status status = ts_plan_stages_deferring(plan, sim, first, last);

	ts_deferred_loops_run(sim);
	return status;
}

enum ts_status ts_plan_have_all(struct ts_plan *plan, struct tsim *sim)
{
	bool resuming = sim->run.resuming;

	if (sim->run.looks) {
		TS_TRY(sim->tables->divide(plan, sim));
		sim->run.resuming = true; /* the sums of the last step are known since the look */
	}
	if (sim->division)
		TS_TRY(sim->tables->gather(plan, sim, true));
	sim->run.resuming = resuming;
	return TS_OK;
}
