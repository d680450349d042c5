/* The void fraction that belongs to the velocities, where e u is stepped forward (form
 * conservative).
 *
 * The projection makes the fluxes G = e u of a step close the balance of its cells, div G = -de/dt,
 * with de/dt from the step before to this one. The next step carries momentum with these fluxes,
 * d(E u)/dt = -div(G u) + ..., and a uniform velocity stays uniform if dE/dt = -div G: E lags
 * behind e by the share of the first stage in the step (the product of all `take`), times its
 * length. E u is then exactly what flows and what forces give it.
 *
 * On faces e is made of halves of cells, and so are the fluxes through the sides of their volumes:
 * what holds in cells holds there (Harlow & Welch's staggered volumes; F. N. Felten & T. S. Lund,
 * J. Comput. Phys. 215 (2006) 465). */
#include <string.h>

#include "flow/projection.h"

#include "base/banned.h"

static enum ts_status want(const struct ts_projection *p, double *field[3])
{
	for (int d = 0; d < p->fluid.grid.dimensions; d++)
		if (!field[d] && !(field[d] = ts_grid_field(&p->fluid.grid)))
			return TS_NOMEM;
	return TS_OK;
}

enum ts_status ts_projection_room_keep(struct ts_projection *p, double elapsed)
{
	struct ts_fluid *fluid = &p->fluid;
	const size_t bytes = fluid->grid.size * sizeof(double);

	TS_TRY(want(p, p->room_before));
	TS_TRY(want(p, p->room_rate));
	TS_TRY(want(p, p->room_start));
	TS_TRY(want(p, p->room_last));
	TS_TRY(want(p, fluid->inertia));
	p->room_elapsed = elapsed;
	for (int d = 0; d < fluid->grid.dimensions; d++) {
		if (p->empty_known) {
			memcpy(p->room_before[d], fluid->empty_face[d], bytes);
			ts_projection_to_faces(p, d, fluid->empty_rate, p->room_rate[d]);
		} else {
			ts_projection_to_faces(p, d, fluid->empty, p->room_before[d]);
			memset(p->room_rate[d], 0, bytes);
		}
	}
	return TS_OK;
}

/* How far E lags behind e, in steps of the fluid. */
static double lag_of(const struct ts_time_scheme *scheme)
{
	double lag = 1;

	for (int s = 0; s < scheme->stages; s++)
		lag *= scheme->take[s];
	return lag;
}

/* E at the beginning of a step of the fluid: the first one has the rate of the step before. */
static void begin(struct ts_projection *p, int d, double dt)
{
	const double lag = lag_of(&ts_time_schemes[p->time]), done = (double)p->now_at;
	const double *before = p->room_before[d], *rate = p->room_rate[d],
		     *now = p->fluid.empty_face[d];
	double *start = p->room_start[d], *mass = p->fluid.inertia[d];
	const size_t size = p->fluid.grid.size;

#pragma omp parallel for num_threads(p->poisson.threads) schedule(static)
	for (size_t at = 0; at < size; at++) {
		double own = (now[at] - before[at]) / p->room_elapsed;

		start[at] =
			before[at] + dt * (p->now_at > 0 ? (done - lag) * own : -lag * rate[at]);
		mass[at] = start[at];
	}
}

/* E of the end of the stage. */
static void go_on(struct ts_projection *p, int d, const struct ts_predictor *stage, bool first)
{
	const double *before = p->room_before[d], *rate = p->room_rate[d],
		     *now = p->fluid.empty_face[d];
	const double *start = p->room_start[d];
	double *last = p->room_last[d], *mass = p->fluid.inertia[d];
	const double keep = stage->keep, take = stage->take, dt = stage->dt;
	const size_t size = p->fluid.grid.size;

#pragma omp parallel for num_threads(p->poisson.threads) schedule(static)
	for (size_t at = 0; at < size; at++) {
		double change = first ? rate[at] : (now[at] - before[at]) / p->room_elapsed;

		last[at] = mass[at];
		mass[at] = keep * start[at] + take * (last[at] + dt * change);
	}
}

void ts_projection_room_stage(struct ts_projection *p, struct ts_predictor *stage, int s)
{
	const bool first = s == 0 && p->now_at == 0;

	for (int d = 0; d < p->fluid.grid.dimensions; d++) {
		if (s == 0)
			begin(p, d, stage->dt);
		go_on(p, d, stage, first);
		stage->flow[d] = first ? p->room_before[d] : p->fluid.empty_face[d];
		stage->start[d] = p->room_start[d];
		stage->last[d] = p->room_last[d];
		stage->next[d] = p->fluid.inertia[d];
	}
}
