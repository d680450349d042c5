#include "immersed/immersed.h"

#include <math.h>

#include "flow/fluid_slabs.h"

#include "base/banned.h"

/* Fraction of the old pressure gradient that is added in advance to the velocities of outer points. These
 * are not exactly free of divergence, as those inside are: with the whole gradient their pressure would
 * grow in each step. */
static const double OUTER_PRESSURE = 0.5;

/* The same with the incremental projection, also for points deep inside: it would keep what the pressure has
 * there for ever. Less of it is not stable in steps as long as implicit viscosity allows. */
static const double KEPT_PRESSURE = 0.9;

/* Work of an outer point in iterations of a simple loop, for the number of threads. */
enum { OUTER_ROUNDS = 8 };

/* Velocity to be added at a point of component c for the fraction `share` of the old pressure gradient,
 * dt/rho dp/dx, which the projection subtracts again. The predictor of the incremental projection contains
 * all of it, so the rest is subtracted here. The rest is that of p - rho g x: a fluid at rest stays at rest. */
static double pressure_part(const struct ts_fluid *fluid, int c, size_t at, int index, double dt,
			    double share)
{
	const struct ts_grid *grid = &fluid->grid;
	double weight = ts_immersed_weight(fluid, c), part = fluid->incremental ? share - 1 : share;

	part *= dt / fluid->density * (fluid->p[at] - fluid->p[at - (size_t)grid->stride[c]]) /
		grid->gap[c][index];
	return weight == 0 ? part : part + (1 - share) * dt * weight;
}

/* Velocity to be added at a sample for the old pressure gradient: trilinear between the points around it. */
static double sample_pressure_part(const struct ts_fluid *fluid, int c, const struct ts_immersed_sample *b,
				   double dt)
{
	const struct ts_grid *grid = &fluid->grid;
	const ptrdiff_t *stride = grid->stride;
	const double *p = fluid->p + b->corner;
	double w[3][2] = { { 1 - b->t[0], b->t[0] }, { 1 - b->t[1], b->t[1] }, { 1 - b->t[2], b->t[2] } };
	double sum = 0;

	if (fluid->incremental)
		return 0;
	for (int m = 0; m < 2; m++)
		w[c][m] *= dt / fluid->density / grid->gap[c][b->index + m];
	for (int k = 0; k < (grid->dimensions > 2 ? 2 : 1); k++)
		for (int j = 0; j < 2; j++)
			for (int i = 0; i < 2; i++) {
				const double *at = p + i + j * stride[1] + k * stride[2];

				sum += w[0][i] * w[1][j] * w[2][k] * (at[0] - at[-stride[c]]);
			}
	return sum;
}

static inline double between(double a, double b, double t)
{
	return a * (1 - t) + b * t;
}

/* The value of a component at a sample, trilinear between the points around it. */
static double sample_velocity(const struct ts_grid *grid, const double *u, const struct ts_immersed_sample *b)
{
	const double *t = b->t, *at = u + b->corner, *beside = at + grid->stride[1];
	double plane = between(between(at[0], at[1], t[0]), between(beside[0], beside[1], t[0]), t[1]);

	if (grid->dimensions == 2)
		return plane;
	at += grid->stride[2];
	beside += grid->stride[2];
	return between(plane, between(between(at[0], at[1], t[0]), between(beside[0], beside[1], t[0]), t[1]),
		       t[2]);
}

static void force_inside(struct ts_immersed *ib, struct ts_fluid *fluid, int c, double dt)
{
	const double deep = fluid->incremental ? KEPT_PRESSURE : 0;

#pragma omp parallel for num_threads(ts_fluid_team(fluid, ib->first[c + 1] - ib->first[c])) schedule(static)
	for (size_t k = ib->first[c]; k < ib->first[c + 1]; k++) {
		struct ts_immersed_point *p = &ib->point[k];

		p->before = fluid->u[c][p->at];
		if (!p->outside)
			fluid->u[c][p->at] =
				p->target + pressure_part(fluid, c, p->at, p->index, dt, p->deep ? deep : 1);
	}
}

/* The part of the values of outer points that is the same in all iterations. */
static void begin_outer_points(struct ts_immersed *ib, const struct ts_fluid *fluid, int c, double dt)
{
	size_t first = ib->outer_first[c], end = ib->outer_first[c + 1];
	const double share = fluid->incremental ? KEPT_PRESSURE : OUTER_PRESSURE;

#pragma omp parallel for num_threads(ts_fluid_team(fluid, OUTER_ROUNDS *(end - first))) schedule(static)
	for (size_t k = first; k < end; k++) {
		struct ts_immersed_outer *b = &ib->outer[k];
		const struct ts_immersed_point *p = &ib->point[b->point];

		b->fixed = b->surface + pressure_part(fluid, c, p->at, p->index, dt, share);
		for (int m = 0; m < 2; m++)
			b->fixed -= b->out[m].count *
				    (b->surface + sample_pressure_part(fluid, c, &b->out[m], dt));
	}
}

static double outer_target_velocity(const struct ts_immersed *ib, const struct ts_fluid *fluid, int c,
				    const struct ts_immersed_outer *b)
{
	double before = ib->point[b->point].before, u = b->fixed;

	for (int m = 0; m < 2; m++)
		u += b->out[m].count * sample_velocity(&fluid->grid, fluid->u[c], &b->out[m]);
	return before + b->weight * (u - before);
}

/* All new values are computed from the old velocities: samples of an outer point may include other outer
 * points. */
static void force_outer_points(struct ts_immersed *ib, struct ts_fluid *fluid, int c)
{
	size_t first = ib->outer_first[c], end = ib->outer_first[c + 1];

#pragma omp parallel num_threads(ts_fluid_team(fluid, OUTER_ROUNDS *(end - first)))
	{
#pragma omp for schedule(static)
		for (size_t k = first; k < end; k++)
			ib->outer[k].next = outer_target_velocity(ib, fluid, c, &ib->outer[k]);
#pragma omp for schedule(static)
		for (size_t k = first; k < end; k++)
			fluid->u[c][ib->point[ib->outer[k].point].at] = ib->outer[k].next;
	}
}

/* ---- ranks that have the fluid in some planes only */

static void share_velocity(const struct ts_immersed *ib, const struct ts_fluid *fluid)
{
	for (int c = 0; c < fluid->grid.dimensions && ts_fluid_divided(fluid); c++)
		ts_fluid_slabs_share_beside(fluid, fluid->u[c], ib->planes_beside, ib->planes_beside);
}

/* Points and samples read the pressure of the last projection. */
static void share_pressure(const struct ts_immersed *ib, const struct ts_fluid *fluid)
{
	if (ts_fluid_divided(fluid))
		ts_fluid_slabs_share_beside(fluid, fluid->p, ib->planes_beside, ib->planes_beside);
}

void ts_immersed_force(struct ts_immersed *ib, struct ts_fluid *fluid, double dt, int iterations)
{
	const int dimensions = fluid->grid.dimensions;

	share_pressure(ib, fluid);
	if (ts_fluid_divided(fluid) && fluid->grid.periodic[2])
		ts_fluid_fill_periodic(fluid, fluid->p);
	for (int c = 0; c < dimensions; c++) {
		force_inside(ib, fluid, c, dt);
		begin_outer_points(ib, fluid, c, dt);
	}
	for (int m = 0; m < iterations && ib->beside; m++) {
		share_velocity(ib, fluid);
		if (ib->reads_ghosts)
			ts_fluid_fill_velocity(fluid, fluid->u);
		for (int c = 0; c < dimensions; c++)
			force_outer_points(ib, fluid, c);
	}
	ts_immersed_add_impulses(ib, fluid, dt);
}

void ts_immersed_rehearse_force(const struct ts_immersed *ib, const struct ts_fluid *fluid, int iterations)
{
	share_pressure(ib, fluid);
	for (int m = 0; m < iterations && ib->beside; m++)
		share_velocity(ib, fluid);
}
