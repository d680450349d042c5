/* The projection: pressure that makes the velocity free of divergence. */
#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "flow/boundary.h"
#include "flow/particle_sources.h"
#include "flow/pressure_projection.h"
#include "flow/projection.h"
#include "flow/slab_step.h"
#include "flow/void_fraction.h"
#include "poisson/pressure_choice.h"

#include "base/banned.h"

/* div u in the cells of a row. */
TS_CLONES
static void divergence_row(const struct ts_fluid *fluid, int j, int k, double *out)
{
	const struct ts_grid *grid = &fluid->grid;
	const size_t at = ts_at(grid, 0, j, k);
	const ptrdiff_t sy = grid->stride[1], sz = grid->stride[2];
	const double *u = fluid->u[0] + at, *v = fluid->u[1] + at;
	const double *w = grid->dimensions == 3 ? fluid->u[2] + at : NULL;
	const double *width = grid->width[0], wy = 1 / grid->width[1][j];
	const double wz = grid->dimensions == 3 ? 1 / grid->width[2][k] : 0;
	const int n = grid->n[0];

	if (grid->dimensions == 3) {
#pragma omp simd
		for (int i = 0; i < n; i++)
			out[i] = (u[i + 1] - u[i]) / width[i] + (v[i + sy] - v[i]) * wy +
				 (w[i + sz] - w[i]) * wz;
	} else {
#pragma omp simd
		for (int i = 0; i < n; i++)
			out[i] = (u[i + 1] - u[i]) / width[i] + (v[i + sy] - v[i]) * wy;
	}
}

/* div(e u) + de/dt. */
TS_CLONES
static void divergence_row_void(const struct ts_fluid *fluid, int j, int k, double *out)
{
	const struct ts_grid *grid = &fluid->grid;
	const size_t at = ts_at(grid, 0, j, k);

	memcpy(out, fluid->void_fraction_rate + at, (size_t)grid->n[0] * sizeof *out);
	for (int d = 0; d < grid->dimensions; d++) {
		const double *u = fluid->u[d] + at, *e = fluid->void_fraction_face[d] + at;
		const double *width = grid->width[d] + (d == 1 ? j : d == 2 ? k : 0);
		const ptrdiff_t s = grid->stride[d];

		if (d == 0) {
#pragma omp simd
			for (int i = 0; i < grid->n[0]; i++)
				out[i] += (e[i + s] * u[i + s] - e[i] * u[i]) / width[i];
			continue;
		}
#pragma omp simd
		for (int i = 0; i < grid->n[0]; i++)
			out[i] += (e[i + s] * u[i + s] - e[i] * u[i]) / width[0];
	}
}

void ts_flow_divergence_row(const struct ts_fluid *fluid, int j, int k, double *out)
{
	if (fluid->void_fraction)
		divergence_row_void(fluid, j, k, out);
	else
		divergence_row(fluid, j, k, out);
}

/* rhs = scale (div u - mean) */
static void make_right_hand_side(const struct ts_projection *p, double scale, double mean)
{
	const struct ts_grid *grid = &p->fluid.grid;
	long first, end;

	ts_slabs_rows(&p->slabs, grid->n[2], grid->n[1], 0, &first, &end);
#pragma omp parallel for num_threads(p->poisson.threads) schedule(static)
	for (long line = first; line < end; line++) {
		int j = (int)(line % grid->n[1]), k = (int)(line / grid->n[1]);
		double *row = p->rhs + ts_at(grid, 0, j, k);

		ts_flow_divergence_row(&p->fluid, j, k, row);
		for (int i = 0; i < grid->n[0]; i++)
			row[i] = scale * (row[i] - mean);
	}
}

/* The same with a weight w of the faces, and their void fraction (NULL: 1). */
TS_CLONES
static void subtract_weighted_row(const double *weight, const double *e, const double *p, ptrdiff_t s,
				  const double *gap, bool along, double factor, double *u, int n)
{
	if (along && e) {
#pragma omp simd
		for (int i = 0; i < n; i++)
			u[i] -= factor * weight[i] / e[i] * (p[i] - p[i - s]) / gap[i];
	} else if (e) {
#pragma omp simd
		for (int i = 0; i < n; i++)
			u[i] -= factor * weight[i] / e[i] * (p[i] - p[i - s]) / gap[0];
	} else if (along) {
#pragma omp simd
		for (int i = 0; i < n; i++)
			u[i] -= factor * weight[i] * (p[i] - p[i - s]) / gap[i];
	} else {
#pragma omp simd
		for (int i = 0; i < n; i++)
			u[i] -= factor * weight[i] * (p[i] - p[i - s]) / gap[0];
	}
}

/* u -= factor grad p on the faces of component c where the velocity is not given. With an exchange
 * coefficient the factor is multiplied by weight/void fraction of the face. */
TS_CLONES
static void subtract_gradient_row(const struct ts_projection *projection, const double *pressure, int c,
				  int j, int k, int from, int to, double factor)
{
	const struct ts_fluid *fluid = &projection->fluid;
	const struct ts_grid *grid = &fluid->grid;
	const size_t at = ts_at(grid, from, j, k);
	const ptrdiff_t s = grid->stride[c];
	const double *p = pressure + at, *gap = grid->gap[c] + (c == 0 ? from : c == 1 ? j : k);
	const int n = to - from;
	double *u = fluid->u[c] + at;

	if (fluid->exchange[c] || ts_projection_conservative(projection)) {
		const double *e = fluid->void_fraction_face[c];

		subtract_weighted_row(projection->weight[c] + at, e ? e + at : NULL, p, s, gap, c == 0,
				      factor, u, n);
	} else if (c == 0) {
#pragma omp simd
		for (int i = 0; i < n; i++)
			u[i] -= factor * (p[i] - p[i - 1]) / gap[i];
	} else {
		factor /= gap[0];
#pragma omp simd
		for (int i = 0; i < n; i++)
			u[i] -= factor * (p[i] - p[i - s]);
	}
}

static void subtract_gradient(const struct ts_projection *p, const double *pressure, double factor)
{
	const struct ts_grid *grid = &p->fluid.grid;
	int from[3][3], to[3][3], height = grid->n[1] + 1;
	long first, end;

	for (int c = 0; c < grid->dimensions; c++)
		ts_flow_unknowns(&p->fluid, c, from[c], to[c]);
	ts_slabs_rows(&p->slabs, grid->n[2], height, grid->dimensions == 3, &first, &end);
#pragma omp parallel for num_threads(p->poisson.threads) schedule(static)
	for (long line = first; line < end; line++) {
		int j = (int)(line % height), k = (int)(line / height);

		for (int c = 0; c < grid->dimensions; c++)
			if (j >= from[c][1] && j < to[c][1] && k >= from[c][2] && k < to[c][2])
				subtract_gradient_row(p, pressure, c, j, k, from[c][0], to[c][0], factor);
	}
}

enum ts_status ts_projection_solver(struct ts_instance *self, struct tsim *sim, double held)
{
	struct ts_projection *p = self->state;
	struct ts_instance *pressure;
	bool weighted;

	if (ts_projection_face_weights(p, held) != TS_OK)
		return ts_nomem(&sim->error);
	weighted = p->poisson.weight[0];
	TS_TRY(ts_pressure_choose(sim, &p->poisson, &self->where, &pressure));
	if (pressure == p->pressure && p->removals == sim->removals && p->weights_vary == weighted)
		return TS_OK;
	TS_TRY(ts_pressure_style_of(pressure)->prepare(pressure, sim, &p->poisson));
	p->pressure = pressure;
	p->removals = sim->removals;
	p->weights_vary = weighted;
	if (ts_slab_step_check_solver(p, sim) && ts_projection_face_weights(p, held) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

/* p += phi - theta mu div u*; rhs is rho/dt div u*. */
static void add_increment(struct ts_projection *p, double dt)
{
	struct ts_fluid *fluid = &p->fluid;
	const struct ts_grid *grid = &fluid->grid;
	const double share = p->theta * fluid->viscosity * dt / fluid->density;
	long first, end;

	ts_slabs_rows(&p->slabs, grid->n[2], grid->n[1], 0, &first, &end);
#pragma omp parallel for num_threads(p->poisson.threads) schedule(static)
	for (long line = first; line < end; line++) {
		size_t at = ts_at(grid, 0, (int)(line % grid->n[1]), (int)(line / grid->n[1]));

		for (size_t behind = at + (size_t)grid->n[0]; at < behind; at++)
			fluid->p[at] += p->increment[at] - share * p->rhs[at];
	}
	ts_slab_step_solved(p, fluid->p);
	ts_fluid_fill_pressure(fluid, fluid->p);
}

/* While ranks have slabs: all get the whole right-hand side, unless the solver is divided by the same slabs. */
static enum ts_status solve(struct ts_projection *p, struct tsim *sim, double *pressure,
			    struct ts_poisson_report *report)
{
	const struct ts_pressure_style *style = ts_pressure_style_of(p->pressure);
	const bool divided = style->divided && style->divided(p->pressure);

	if (!divided)
		ts_slab_step_share(p, p->rhs);
	TS_TRY(style->solve(p->pressure, sim, p->rhs, pressure, report));
	if (divided)
		ts_slab_step_solved(p, pressure);
	return TS_OK;
}

enum ts_status ts_projection_project_velocity(struct ts_instance *self, struct tsim *sim, double dt,
					      double held)
{
	struct ts_projection *p = self->state;
	struct ts_fluid *fluid = &p->fluid;
	struct ts_poisson_report report = { 0 };
	double *pressure = fluid->incremental ? p->increment : fluid->p, mean;

	TS_TRY(ts_projection_solver(self, sim, held));
	TS_TRY(ts_projection_net_outflow(self, sim, &mean));
	fluid->excess = mean;
	make_right_hand_side(p, fluid->density / dt, mean);
	if (ts_projection_impose_pressure(p) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(solve(p, sim, pressure, &report));
	fluid->iterations = report.iterations;
	ts_fluid_fill_relative(fluid, pressure);
	subtract_gradient(p, pressure, dt / fluid->density);
	ts_projection_restore_pressure(p);
	if (pressure != fluid->p)
		add_increment(p, dt);
	ts_slab_step_corrected(p);
	ts_fluid_fill_velocity(fluid, fluid->u);
	return TS_OK;
}

enum ts_status ts_projection_project_initial(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;
	struct ts_fluid *fluid = &p->fluid;
	const struct ts_grid *grid = &fluid->grid;
	enum ts_status status;
	bool incremental;

	ts_fluid_fill_velocity(fluid, fluid->u);
	/* The velocity does not depend on the time step; this one makes the pressure of order 1. */
	incremental = fluid->incremental;
	fluid->incremental = false;
	p->initial_projection = true;
	status = ts_projection_project_velocity(self, sim, fluid->density * grid->width[0][0], 0);
	fluid->incremental = incremental;
	p->initial_projection = false;
	TS_TRY(status);
	ts_grid_field_clear(fluid->p, 0, grid->size);
	if (p->increment)
		ts_grid_field_clear(p->increment, 0, grid->size);
	p->history_dt = 0;
	p->fluid.steps = 0;
	p->fluid.time = ts_sim_time(sim);
	return TS_OK;
}
