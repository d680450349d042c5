#include "core/stepping.h"

#include "core/fingerprint.h"
#include "core/restored_models.h"

#include "base/banned.h"

enum ts_status ts_stepping_watch(struct ts_stepping *stepping, struct tsim *sim)
{
	if (!stepping->open || stepping->watched)
		return TS_OK;
	TS_TRY(ts_sim_fingerprint(sim, &stepping->fingerprint));
	stepping->watched = true;
	return TS_OK;
}

static void release_run(struct ts_stepping *stepping, struct tsim *sim)
{
	ts_plan_release(&stepping->plan);
	stepping->open = stepping->watched = false;
	sim->run.in_pieces = false;
}

/* The next run resumes if the state is still that at the end of the last piece. */
enum ts_status ts_stepping_end(struct ts_stepping *stepping, struct tsim *sim)
{
	enum ts_status status;

	if (!stepping->open)
		return TS_OK;
	status = ts_stepping_watch(stepping, sim);
	if (status == TS_OK)
		status = ts_plan_finish(&stepping->plan, sim);
	sim->run.fingerprint = status == TS_OK ? stepping->fingerprint : 0;
	release_run(stepping, sim);
	return status;
}

static enum ts_status is_unchanged(struct ts_stepping *stepping, struct tsim *sim, bool *yes)
{
	bool differs = false;

	*yes = stepping->open;
	if (!stepping->open || !stepping->watched)
		return TS_OK;
	TS_TRY(ts_fingerprint_differs(sim, stepping->fingerprint, &differs));
	*yes = !differs;
	return TS_OK;
}

static enum ts_status begin_run(struct ts_stepping *stepping, struct tsim *sim, int64_t n)
{
	sim->clock.first_step = sim->clock.ramp_first = sim->clock.step;
	sim->clock.last_step = sim->clock.ramp_last = sim->clock.step + n;
	sim->run.unsafe = false;
	sim->run.in_pieces = stepping->open = true;
	TS_TRY(ts_restore_models(sim));
	TS_TRY(ts_plan_compile(&stepping->plan, sim));
	return ts_plan_start(&stepping->plan, sim, true);
}

static enum ts_status advance_run(struct ts_stepping *stepping, struct tsim *sim, int64_t n)
{
	bool on = false;
	int64_t last;

	if (sim->run.halted)
		return TS_OK;
	TS_TRY(is_unchanged(stepping, sim, &on));
	if (!on) {
		TS_TRY(ts_stepping_end(stepping, sim));
		TS_TRY(begin_run(stepping, sim, n));
	}
	last = sim->clock.goal = sim->clock.last_step = sim->clock.ramp_last = sim->clock.step + n;
	if (sim->reading.explain)
		return TS_OK;
	stepping->watched = false;
	TS_TRY(ts_plan_steps(&stepping->plan, sim));
	if (sim->clock.step < last && !sim->requests.stop) /* fix halt */
		return ts_stepping_end(stepping, sim);
	if (stepping->always)
		TS_TRY(ts_stepping_watch(stepping, sim));
	return ts_plan_stopped(sim);
}

enum ts_status ts_stepping_advance(struct ts_stepping *stepping, struct tsim *sim, int64_t n)
{
	enum ts_status status = advance_run(stepping, sim, n);

	if (status == TS_STOPPED)
		ts_stepping_end(stepping, sim);
	else if (status != TS_OK || sim->reading.explain)
		release_run(stepping, sim);
	return status;
}
