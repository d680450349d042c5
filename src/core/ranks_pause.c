#include "core/ranks_pause.h"

#include "core/fingerprint.h"

#include "base/banned.h"

enum ts_status ts_ranks_pause(struct tsim *sim, struct ts_plan *plan)
{
	struct ts_plan *kept = ts_alloc(1, sizeof *kept);

	if (!kept)
		return ts_nomem(&sim->error);
	*kept = *plan;
	*plan = (struct ts_plan){ 0 };
	sim->run.paused = kept;
	return TS_OK;
}

void ts_ranks_end_pause(struct tsim *sim)
{
	if (sim->run.paused)
		ts_plan_release(sim->run.paused);
	ts_free(sim->run.paused);
	sim->run.paused = NULL;
}

/* Whether anything that forces depend on has changed since the run. The order of the particles is not the same on all
 * ranks, and so neither is the fingerprint. */
static enum ts_status find_changed(struct tsim *sim, bool *changed)
{
	uint64_t fingerprint;
	double most;

	TS_TRY(ts_sim_fingerprint(sim, &fingerprint));
	most = fingerprint != sim->run.fingerprint;
	ts_world_most(sim->world, &most, 1);
	*changed = most > 0;
	return TS_OK;
}

static enum ts_status unite(struct tsim *sim, struct ts_plan *plan)
{
	bool changed;

	TS_TRY(find_changed(sim, &changed));
	sim->run.inside = true;
	TS_TRY(ts_plan_have_all(plan, sim));
	sim->run.inside = false;
	sim->run.fingerprint = 0;
	return changed ? TS_OK : ts_sim_fingerprint(sim, &sim->run.fingerprint);
}

enum ts_status ts_ranks_unite(struct tsim *sim)
{
	struct ts_plan *plan = sim->run.paused;
	enum ts_status status;

	if (!plan)
		return TS_OK;
	sim->run.paused = NULL; /* the fingerprint evaluates formulas */
	status = unite(sim, plan);
	sim->run.paused = plan;
	ts_ranks_end_pause(sim);
	return status;
}
