#include "core/ranks_pause.h"

#include "core/ranks.h"

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

bool ts_ranks_have_read(const struct ts_plan *plan)
{
	return plan && !plan->n[TS_STAGE_BUILD];
}

/* All ranks get all particles, with their lists or for a look. */
static enum ts_status get_all(struct tsim *sim, struct ts_plan *plan, bool lists)
{
	bool unchanged = true;

	if (!ts_ranks_have_read(plan))
		TS_TRY(ts_plan_is_unchanged(sim, &unchanged));
	sim->run.inside = true;
	TS_TRY(lists ? ts_plan_have_all(plan, sim) : sim->tables->gather(plan, sim, false));
	sim->run.inside = false;
	sim->run.fingerprint = unchanged ? sim->run.fingerprint : 0;
	return TS_OK;
}

/* The same while formulas, which the fingerprint evaluates, ask for nothing more. */
static enum ts_status get_all_once(struct tsim *sim, bool lists)
{
	struct ts_plan *plan = sim->run.paused;
	enum ts_status status;

	sim->run.paused = NULL;
	status = get_all(sim, plan, lists);
	sim->run.paused = plan;
	return status;
}

enum ts_status ts_ranks_look(struct tsim *sim)
{
	if (sim->run.rowwise) /* the command has counted the particles of this rank */
		return ts_fail(&sim->error, TS_STATE, NULL,
			       "a value that depends on all particles is needed while a command acts on "
			       "those of each rank");
	return sim->run.paused && sim->division ? get_all_once(sim, false) : TS_OK;
}

enum ts_status ts_ranks_require_all(struct tsim *sim, const char *name, const struct ts_place *where)
{
	if (!sim->run.apart)
		return ts_ranks_look(sim);
	/* not TS_STATE, which -explain takes for a consequence of values that runs give */
	return ts_fail(&sim->error, TS_SYNTAX, where,
		       "'%s' is needed in each step, when each rank has its own particles only (there are "
		       "%d ranks): expected the time, the step, the box, numbers of the fluid and variables "
		       "of these; run tsim without mpirun, with threads (OMP_NUM_THREADS); see doc/ranks.md",
		       name, ts_ranks(sim));
}

enum ts_status ts_ranks_unite(struct tsim *sim)
{
	enum ts_status status;

	sim->run.rowwise = false;
	if (!sim->run.paused)
		return TS_OK;
	status = get_all_once(sim, true);
	ts_ranks_end_pause(sim);
	return status;
}

void ts_ranks_forget(struct tsim *sim, const struct ts_instance *inst)
{
	struct ts_plan *plan = sim->run.paused;

	for (int stage = 0; plan && stage < TS_NSTAGE; stage++) {
		size_t kept = 0;

		for (size_t k = 0; k < plan->n[stage]; k++)
			if (plan->actions[stage][k].self != inst)
				plan->actions[stage][kept++] = plan->actions[stage][k];
		plan->n[stage] = kept;
	}
}
