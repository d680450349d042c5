/* How a step went: cheap enough to look at each of them. */
#include <math.h>

#include "flow/projection.h"

#include "base/banned.h"

struct look {
	double speed; /* sum |u|/h */
	double change;
	bool broken; /* something is not a number */
};

static struct look look_at_row(const struct ts_fluid *fluid, double *const before[3], int j, int k)
{
	const struct ts_grid *grid = &fluid->grid;
	const size_t at = ts_at(grid, 0, j, k);
	const bool solid = grid->dimensions == 3;
	const double *u = fluid->u[0] + at, *v = fluid->u[1] + at, *w = fluid->u[solid ? 2 : 1] + at;
	const double *a = before[0] + at, *b = before[1] + at, *c = before[solid ? 2 : 1] + at;
	const double *width = grid->width[0], wy = 1 / grid->width[1][j];
	const double wz = solid ? 1 / grid->width[2][k] : 0;
	double speed = 0, change = 0, nothing = 0;

#pragma omp simd reduction(max : speed, change) reduction(+ : nothing)
	for (int i = 0; i < grid->n[0]; i++) {
		double s = fabs(u[i]) / width[i] + fabs(v[i]) * wy + fabs(w[i]) * wz;
		double x = fabs(u[i] - a[i]), y = fabs(v[i] - b[i]), z = fabs(w[i] - c[i]);
		double most = x > y ? x : y;

		most = most > z ? most : z;
		speed = s > speed ? s : speed;
		change = most > change ? most : change;
		nothing += 0 * s; /* not a number if s is not */
	}
	return (struct look){ speed, change, !(nothing == 0) };
}

static double largest_divergence(const struct ts_fluid *fluid, int j, int k, double *row)
{
	double most = 0;

	ts_flow_divergence_row(fluid, j, k, row);
	for (int i = 0; i < fluid->grid.n[0]; i++)
		most = fabs(row[i]) > most ? fabs(row[i]) : most;
	return most;
}

enum ts_status ts_projection_watch(struct ts_instance *self, struct tsim *sim, double *const before[3],
				   double dt)
{
	struct ts_projection *p = self->state;
	struct ts_fluid *fluid = &p->fluid;
	const struct ts_grid *grid = &fluid->grid;
	long rows = (long)grid->n[1] * grid->n[2];
	double speed = 0, change = 0, divergence = 0;
	int broken = 0;

#pragma omp parallel for num_threads(p->poisson.threads) schedule(static)                          \
	reduction(max : speed, change, divergence) reduction(| : broken)
	for (long line = 0; line < rows; line++) {
		int j = (int)(line % grid->n[1]), k = (int)(line / grid->n[1]);
		struct look look = look_at_row(fluid, before, j, k);

		speed = fmax(speed, look.speed);
		change = fmax(change, look.change);
		broken |= look.broken;
		divergence = fmax(divergence, largest_divergence(fluid, j, k,
								 p->rhs + ts_at(grid, 0, j, k)));
	}
	fluid->courant = speed * dt;
	fluid->residual = change / dt;
	fluid->divergence = divergence;
	if (broken)
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "the fluid's velocity is not a number any more at time %g", fluid->time);
	return TS_OK;
}
