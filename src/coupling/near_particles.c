#include "coupling/near_particles.h"

#include <math.h>

#include "base/alloc.h"
#include "core/ranks.h"
#include "flow/flow.h"
#include "flow/slab_step.h"
#include "particle/division.h"
#include "particle/particles.h"

#include "base/banned.h"

/* How far own particles are from the block of this rank, at most along one axis. */
static double find_distance(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	double low[3], high[3], most = 0;

	for (int d = 0; d < 3; d++) {
		const struct ts_rank_side side =
			ts_rank_blocks_side(&sim->division->blocks, sim->world->rank, d);

		low[d] = side.open[0] ? -INFINITY : side.face[0];
		high[d] = side.open[1] ? INFINITY : side.face[1];
	}
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static) reduction(max : most)
	for (size_t i = 0; i < p->n; i++)
		for (int d = 0; d < 3; d++) {
			const double below = low[d] - p->x[i][d], above = p->x[i][d] - high[d];

			most = below > most ? below : most;
			most = above > most ? above : most;
		}
	return most;
}

static bool agreed_in_this_step(const struct ts_fluid_near *near, const struct tsim *sim)
{
	return near->agreed == sim->clock.step && near->era == sim->era && near->begun != sim->clock.step;
}

/* With room for the next steps. */
static void widen(struct ts_fluid_near *near, double distance)
{
	if (distance <= near->margin)
		return;
	near->margin = 2 * distance;
	near->ranks = 0;
}

/* All particles are on all ranks, or fixes that read the fluid have come since it has been set up. */
static enum ts_status follow_changes(struct ts_fluid *fluid, struct tsim *sim)
{
	struct ts_projection *p = ts_sim_only(sim, TS_KIND_FLOW)->state;

	if (!ts_fluid_divided(fluid) || (sim->division && fluid->near.active))
		return TS_OK;
	fluid->near.stale = fluid->near.wanted = true;
	return ts_slab_step_begin_apart(p, sim, ts_division_blocks_now(sim)) == TS_OK ? TS_OK
										      : ts_nomem(&sim->error);
}

enum ts_status ts_near_particles_agree(struct ts_fluid *fluid, struct tsim *sim, double *value, size_t n)
{
	enum { MOST = 4 };
	struct ts_fluid_near *near = &fluid->near;
	double all[MOST + 1];

	TS_TRY(follow_changes(fluid, sim));
	if (!near->active) {
		ts_ranks_most_of(sim, value, n);
		return TS_OK;
	}
	for (size_t k = 0; k < n && k < MOST; k++)
		all[k] = value[k];
	all[n] = find_distance(sim);
	ts_ranks_most_of(sim, all, n + 1);
	for (size_t k = 0; k < n && k < MOST; k++)
		value[k] = all[k];
	near->agreed = sim->clock.step;
	near->era = sim->era;
	widen(near, all[n]);
	return ts_slab_step_renew(ts_sim_only(sim, TS_KIND_FLOW)->state, sim, &sim->division->blocks) == TS_OK
		       ? TS_OK
		       : ts_nomem(&sim->error);
}

enum ts_status ts_near_particles_ready(struct ts_fluid *fluid, struct tsim *sim)
{
	if (!fluid)
		return TS_OK;
	TS_TRY(follow_changes(fluid, sim));
	if (!fluid->near.active || agreed_in_this_step(&fluid->near, sim))
		return TS_OK;
	return ts_near_particles_agree(fluid, sim, NULL, 0);
}

void ts_near_particles_reach(struct ts_fluid *fluid, int reach)
{
	if (reach <= fluid->near.reach)
		return;
	fluid->near.reach = reach;
	fluid->near.ranks = 0;
}
