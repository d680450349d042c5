/* The void fraction e as the equations of the fluid use it: on faces, its rate of change, and its values
 * in the momentum if e u is stepped forward (form conservative). */

#include "base/alloc.h"
#include "flow/flow.h"
#include "flow/fluid_slabs.h"
#include "flow/projection.h"
#include "flow/void_fraction.h"

#include "base/banned.h"

/* The rows first .. end - 1 of a range of planes, ghosts included. */
static void find_rows(const struct ts_fluid *fluid, int range, long *first, long *end)
{
	const struct ts_grid *grid = &fluid->grid;
	const int height = grid->n[1] + 2 * grid->ghosts[1];
	const bool divided = ts_fluid_divided(fluid);
	const int from = divided ? fluid->planes.range[range].from : -grid->ghosts[2],
		  to = divided ? fluid->planes.range[range].to : grid->n[2] + grid->ghosts[2];

	*first = (long)(from + grid->ghosts[2]) * height;
	*end = (long)(to + grid->ghosts[2]) * height;
}

/* Index of the first value of a row, ghosts included; a row has n + 2 ghosts values. */
static size_t row_start(const struct ts_grid *grid, long line, int *j, int *k)
{
	int height = grid->n[1] + 2 * grid->ghosts[1];

	*j = (int)(line % height) - grid->ghosts[1];
	*k = (int)(line / height) - grid->ghosts[2];
	return ts_at(grid, -grid->ghosts[0], *j, *k);
}

static void interpolate_row_to_faces(const struct ts_projection *p, int d, long line, const double *e,
				     double *face)
{
	const struct ts_grid *grid = &p->fluid.grid;
	const ptrdiff_t s = grid->stride[d];
	const int n = grid->n[0] + 2 * grid->ghosts[0];
	const double *part = p->operators.mass[d];
	int j, k;
	size_t at = row_start(grid, line, &j, &k);
	const bool lowest = (d == 1 && j == -grid->ghosts[1]) || (d == 2 && k == -grid->ghosts[2]);

	for (int i = 0; i < n; i++, at++) {
		int m = d == 0 ? i - grid->ghosts[0] : d == 1 ? j : k;

		face[at] = lowest || (d == 0 && i == 0)
				   ? e[at]
				   : part[m] * e[(ptrdiff_t)at - s] + (1 - part[m]) * e[at];
	}
}

/* In a rank's lowest ghost plane, below which it has none, faces across z are not those of the whole grid, and not used. */
static void interpolate_to_faces(const struct ts_projection *p, int d, const double *e, double *face)
{
	for (int range = 0; range < ts_fluid_ranges(&p->fluid); range++) {
		long first, end;

		find_rows(&p->fluid, range, &first, &end);
#pragma omp parallel for num_threads(p->poisson.threads) schedule(static)
		for (long line = first; line < end; line++)
			interpolate_row_to_faces(p, d, line, e, face);
	}
}

/* ---- form conservative: the void fraction E of the momentum, whose product E u is stepped forward
 *
 * After the projection the fluxes G = e u of a step satisfy the continuity equation of each cell,
 * div G = -de/dt, with de/dt from the step before to this one. The next step convects momentum with these
 * fluxes, d(E u)/dt = -div(G u) + ..., and a uniform velocity stays uniform if dE/dt = -div G: E lags
 * behind e by the weight of the first stage in the step (the product of all `take`) times the length of
 * the step. The change of E u is then exactly the sum of fluxes and forces.
 *
 * On a face e is the mean of the two cells, weighted by their halves, and so are the fluxes through the
 * sides of the control volume of the face: continuity of the cells implies that of the control volumes
 * (staggered grid of Harlow & Welch; F. N. Felten & T. S. Lund, J. Comput. Phys. 215 (2006) 465). */

static enum ts_status allocate_vector(const struct ts_projection *p, double *field[3])
{
	for (int d = 0; d < p->fluid.grid.dimensions; d++)
		if (!field[d] && !(field[d] = ts_grid_field(&p->fluid.grid)))
			return TS_NOMEM;
	return TS_OK;
}

static enum ts_status store_momentum_void_fraction(struct ts_projection *p, double elapsed)
{
	struct ts_fluid *fluid = &p->fluid;

	TS_TRY(allocate_vector(p, p->void_before));
	TS_TRY(allocate_vector(p, p->void_rate));
	TS_TRY(allocate_vector(p, p->void_start));
	TS_TRY(allocate_vector(p, p->void_stage));
	TS_TRY(allocate_vector(p, fluid->momentum_void_fraction));
	p->void_elapsed = elapsed;
	for (int d = 0; d < fluid->grid.dimensions; d++) {
		if (p->empty_known) {
			ts_fluid_copy_field(fluid, p->void_before[d], fluid->void_fraction_face[d]);
			interpolate_to_faces(p, d, fluid->void_fraction_rate, p->void_rate[d]);
		} else {
			interpolate_to_faces(p, d, fluid->void_fraction, p->void_before[d]);
			ts_grid_field_clear(p->void_rate[d], 0, fluid->grid.size);
		}
	}
	return TS_OK;
}

/* ---- at the beginning of a step of the fluid */

static void make_void_rate(const struct ts_projection *p, double elapsed)
{
	const struct ts_fluid *fluid = &p->fluid;
	const double *e = fluid->void_fraction;
	double *rate = fluid->void_fraction_rate, *before = p->void_fraction_before;
	const double per_time = p->empty_known ? 1 / elapsed : 0;

	for (int range = 0; range < ts_fluid_ranges(fluid); range++) {
		size_t first, end;

		ts_fluid_range_values(fluid, range, &first, &end);
#pragma omp parallel for num_threads(p->poisson.threads) schedule(static)
		for (size_t k = first; k < end; k++) {
			rate[k] = (e[k] - before[k]) * per_time;
			before[k] = e[k];
		}
	}
}

void ts_projection_find_void_fraction(struct ts_projection *p, const struct tsim *sim)
{
	size_t k = 0;

	if (!p->fluid.void_of_fix || ts_flow_part_named(sim, "void_fraction", &k))
		return;
	ts_fluid_release_void_fraction(&p->fluid);
	p->fluid.void_of_fix = false;
	p->empty_known = 0;
}

enum ts_status ts_projection_update_void_fraction(struct ts_projection *p, double elapsed)
{
	struct ts_fluid *fluid = &p->fluid;

	if (!fluid->void_fraction)
		return TS_OK;
	if (!p->void_fraction_before && !(p->void_fraction_before = ts_grid_field(&fluid->grid)))
		return TS_NOMEM;
	if (fluid->void_anew)
		p->empty_known = 0;
	fluid->void_anew = false;
	ts_fluid_fill_centred(fluid, fluid->void_fraction);
	if (ts_projection_conservative(p))
		TS_TRY(store_momentum_void_fraction(p, elapsed));
	make_void_rate(p, elapsed);
	p->empty_known = 1;
	for (int d = 0; d < fluid->grid.dimensions; d++)
		interpolate_to_faces(p, d, fluid->void_fraction, fluid->void_fraction_face[d]);
	return TS_OK;
}

/* Of the rows of this rank: the integral of de/dt along x. */
static void integrate_rows(const struct ts_projection *p, double *row)
{
	const struct ts_grid *grid = &p->fluid.grid;
	long first, end;

	ts_fluid_slabs_rows(&p->fluid, &first, &end);
	for (long line = first; line < end; line++) {
		const int j = (int)(line % grid->n[1]), k = (int)(line / grid->n[1]);
		const double *rate = p->fluid.void_fraction_rate + ts_at(grid, 0, j, k);

		row[line] = 0;
		for (int i = 0; i < grid->n[0]; i++)
			row[line] += rate[i] * grid->width[0][i];
	}
}

enum ts_status ts_projection_void_rate_integral(const struct ts_projection *p, double *out)
{
	const struct ts_grid *grid = &p->fluid.grid;
	const size_t height = (size_t)grid->n[1];
	double *row, sum = 0;

	*out = 0;
	if (!p->fluid.void_fraction)
		return TS_OK;
	row = ts_alloc(height * (size_t)grid->n[2], sizeof *row);
	if (!row)
		return TS_NOMEM;
	integrate_rows(p, row);
	ts_slabs_share(&p->slabs, &(struct ts_slabs_field){ row, height, 0, 0 });
	for (int k = 0; k < grid->n[2]; k++)
		for (int j = 0; j < grid->n[1]; j++)
			sum += row[(size_t)k * height + (size_t)j] * grid->width[1][j] * grid->width[2][k];
	ts_free(row);
	*out = sum;
	return TS_OK;
}

/* ---- form conservative: E in the stages of a step */

/* Lag of E behind e, in steps of the fluid. */
static double lag_in_steps(const struct ts_flow_time_scheme *scheme)
{
	double lag = 1;

	for (int s = 0; s < scheme->stages; s++)
		lag *= scheme->take[s];
	return lag;
}

/* E at the beginning of a substep; the first substep uses the rate of the step before. */
static void begin_substep(struct ts_projection *p, int d, double dt)
{
	const double lag = lag_in_steps(&ts_flow_time_schemes[p->time]), done = (double)p->now_at;
	const double *before = p->void_before[d], *rate = p->void_rate[d],
		     *now = p->fluid.void_fraction_face[d];
	double *start = p->void_start[d], *mass = p->fluid.momentum_void_fraction[d];

	for (int range = 0; range < ts_fluid_ranges(&p->fluid); range++) {
		size_t first, end;

		ts_fluid_range_values(&p->fluid, range, &first, &end);
#pragma omp parallel for num_threads(p->poisson.threads) schedule(static)
		for (size_t at = first; at < end; at++) {
			double own = (now[at] - before[at]) / p->void_elapsed;

			start[at] = before[at] + dt * (p->now_at > 0 ? (done - lag) * own : -lag * rate[at]);
			mass[at] = start[at];
		}
	}
}

/* E at the end of the stage. */
static void advance_stage(struct ts_projection *p, int d, const struct ts_predictor *stage, bool first)
{
	const double *before = p->void_before[d], *rate = p->void_rate[d],
		     *now = p->fluid.void_fraction_face[d];
	const double *start = p->void_start[d];
	double *last = p->void_stage[d], *mass = p->fluid.momentum_void_fraction[d];
	const double keep = stage->keep, take = stage->take, dt = stage->dt;

	for (int range = 0; range < ts_fluid_ranges(&p->fluid); range++) {
		size_t from, end;

		ts_fluid_range_values(&p->fluid, range, &from, &end);
#pragma omp parallel for num_threads(p->poisson.threads) schedule(static)
		for (size_t at = from; at < end; at++) {
			double change = first ? rate[at] : (now[at] - before[at]) / p->void_elapsed;

			last[at] = mass[at];
			mass[at] = keep * start[at] + take * (last[at] + dt * change);
		}
	}
}

void ts_projection_stage_void_fraction(struct ts_projection *p, struct ts_predictor *stage, int s)
{
	const bool first = s == 0 && p->now_at == 0;

	for (int d = 0; d < p->fluid.grid.dimensions; d++) {
		if (s == 0)
			begin_substep(p, d, stage->dt);
		advance_stage(p, d, stage, first);
		stage->flow[d] = first ? p->void_before[d] : p->fluid.void_fraction_face[d];
		stage->start[d] = p->void_start[d];
		stage->last[d] = p->void_stage[d];
		stage->next[d] = p->fluid.momentum_void_fraction[d];
	}
}
