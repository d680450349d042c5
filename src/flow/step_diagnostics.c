/* Diagnostics of a substep: Courant number, residual, divergence; and the error if it was unstable.
 * Computed in each substep. */
#include <math.h>
#include <stdio.h>

#include "base/clones.h"
#include "flow/flow_limits.h"
#include "flow/pressure_projection.h"
#include "flow/slab_step.h"
#include "flow/step_diagnostics.h"

#include "base/banned.h"

struct row_diagnostics {
	double speed; /* sum |u|/h */
	double change;
	bool broken; /* a velocity is not a number */
};

TS_CLONES
static struct row_diagnostics diagnose_row(const struct ts_fluid *fluid, double *const before[3], int j,
					   int k)
{
	const struct ts_grid *grid = &fluid->grid;
	const size_t at = ts_at(grid, 0, j, k);
	const bool solid = grid->dimensions == 3;
	const double *u = fluid->u[0] + at, *v = fluid->u[1] + at, *w = fluid->u[solid ? 2 : 1] + at;
	const double *a = before[0] + at, *b = before[1] + at, *c = before[solid ? 2 : 1] + at;
	const double *width = grid->width[0], wy = 1 / grid->width[1][j];
	const double wz = solid ? 1 / grid->width[2][k] : 0;
	double speed = 0, change = 0, not_a_number = 0;

#pragma omp simd reduction(max : speed, change) reduction(+ : not_a_number)
	for (int i = 0; i < grid->n[0]; i++) {
		double s = fabs(u[i]) / width[i] + fabs(v[i]) * wy + fabs(w[i]) * wz;
		double x = fabs(u[i] - a[i]), y = fabs(v[i] - b[i]), z = fabs(w[i] - c[i]);
		double most = x > y ? x : y;

		most = most > z ? most : z;
		speed = s > speed ? s : speed;
		change = most > change ? most : change;
		not_a_number += 0 * s; /* not a number if s is not */
	}
	return (struct row_diagnostics){ speed, change, !(not_a_number == 0) };
}

TS_CLONES
static double largest_size(const double *row, int n)
{
	double most = 0;

#pragma omp simd reduction(max : most)
	for (int i = 0; i < n; i++)
		most = fabs(row[i]) > most ? fabs(row[i]) : most;
	return most;
}

/* The divergence is not kept: rows of usual length are computed in memory that stays in the cache. */
static double largest_divergence(const struct ts_projection *p, int j, int k)
{
	enum { USUAL = 512 };
	const struct ts_grid *grid = &p->fluid.grid;
	double usual[USUAL], *row = grid->n[0] > USUAL ? p->rhs + ts_at(grid, 0, j, k) : usual;

	ts_flow_divergence_row(&p->fluid, j, k, row);
	return largest_size(row, grid->n[0]);
}

/* Tolerance for round-off of a step at the limit. */
static const double MARGIN = 1.000001;

/* Centre of the cell with the largest sum |u|/h. */
static void fastest_cell(const struct ts_fluid *fluid, double x[3])
{
	const struct ts_grid *grid = &fluid->grid;
	double most = -1;

	for (int k = 0; k < grid->n[2]; k++)
		for (int j = 0; j < grid->n[1]; j++)
			for (int i = 0; i < grid->n[0]; i++) {
				const int at[3] = { i, j, k };
				double sum = 0;

				for (int d = 0; d < grid->dimensions; d++)
					sum += fabs(fluid->u[d][ts_at(grid, i, j, k)]) /
					       grid->width[d][at[d]];
				if (!(sum > most))
					continue;
				most = sum;
				for (int d = 0; d < 3; d++)
					x[d] = 0.5 * (grid->face[d][at[d]] + grid->face[d][at[d] + 1]);
			}
}

/* Whether freely moving bodies may be the cause of the instability. */
static bool bodies_explain(const struct tsim *sim, const struct ts_fluid *fluid, double dt, char *cause,
			   size_t size)
{
	const struct ts_instance *part;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		if (flow_part->explain_instability &&
		    flow_part->explain_instability(part, fluid, dt, cause, size))
			return true;
	}
	return false;
}

/* Fails with the limit that the step has exceeded, as far as it is known. */
static enum ts_status fail_unstable(struct ts_instance *self, struct tsim *sim, bool broken, double dt)
{
	struct ts_projection *p = self->state;
	const struct ts_fluid *fluid = &p->fluid;
	struct ts_flow_limits limits;
	const char *time = ts_flow_time_names[p->time];
	double x[3] = { 0 };
	char cause[512];

	ts_slab_step_complete(p, sim);
	limits = ts_flow_limits(p);
	if (bodies_explain(sim, fluid, dt, cause, sizeof cause))
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "the fluid left the region of stable steps at time %g with a step of %g: %s",
			       fluid->time, dt, cause);
	if (broken)
		snprintf(cause, sizeof cause, "a velocity is not a number any more");
	else if (dt > limits.viscous && p->viscosity > 0 && ts_flow_viscous_limit(p) < dt)
		snprintf(cause, sizeof cause, "viscosity %g with time %s is stable for steps up to %g only",
			 p->viscosity, time, ts_flow_viscous_limit(p));
	else {
		fastest_cell(fluid, x);
		snprintf(cause, sizeof cause,
			 "the Courant number sum |u| dt/h is %g in the cell at (%.4g %.4g %.4g), and with "
			 "time %s it must stay below %g",
			 fluid->courant, x[0], x[1], x[2], time, ts_flow_time_schemes[p->time].courant);
	}
	return ts_fail(&sim->error, TS_PHYSICS, &self->where,
		       "the fluid left the region of stable steps at time %g with a step of %g: %s%s; use a "
		       "smaller `timestep`, or `substeps auto` in flow_style",
		       fluid->time, dt, cause,
		       limits.growth < dt && !broken
			       ? " (it may have grown so: convection is damped too little for this step, "
				 "which a scheme `time rk3` or `convection donor` would stand)"
			       : "");
}

enum ts_status ts_projection_check_substep(struct ts_instance *self, struct tsim *sim,
					   double *const before[3], double dt)
{
	struct ts_projection *p = self->state;
	struct ts_fluid *fluid = &p->fluid;
	const struct ts_grid *grid = &fluid->grid;
	double speed = 0, change = 0, divergence = 0;
	int broken = 0;
	long first, end;

	ts_slabs_rows(&p->slabs, grid->n[2], grid->n[1], 0, &first, &end);
#pragma omp parallel for num_threads(p->poisson.threads) schedule(static) \
	reduction(max                                                     \
		  : speed, change, divergence) reduction(|                \
							 : broken)
	for (long line = first; line < end; line++) {
		int j = (int)(line % grid->n[1]), k = (int)(line / grid->n[1]);
		struct row_diagnostics row = diagnose_row(fluid, before, j, k);

		speed = fmax(speed, row.speed);
		change = fmax(change, row.change);
		broken |= row.broken;
		divergence = fmax(divergence, largest_divergence(p, j, k));
	}
	if (p->slabs.active) {
		double most[] = { speed, change, divergence, broken };

		ts_world_most(p->slabs.world, most, 4);
		speed = most[0];
		change = most[1];
		divergence = most[2];
		broken = most[3] > 0;
	}
	fluid->courant = speed * dt;
	fluid->residual = change / dt;
	fluid->divergence = divergence;
	if (broken || !(fluid->courant <= MARGIN * ts_flow_time_schemes[p->time].courant))
		return fail_unstable(self, sim, broken, dt);
	return TS_OK;
}
