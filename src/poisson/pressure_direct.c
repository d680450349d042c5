#include "poisson/poisson.h"

#include <math.h>

#include "poisson/direct_exchange.h"
#include "poisson/pressure_style.h"

#include "base/banned.h"

struct direct {
	struct ts_direct solver;
};

static void fini(struct ts_instance *self)
{
	ts_direct_release(&((struct direct *)self->state)->solver);
}

static bool suits(const struct ts_poisson *problem, const char **why)
{
	*why = "it solves only where the void fraction is 1 everywhere";
	return !problem->weight[0];
}

static enum ts_status prepare(struct ts_instance *self, struct tsim *sim, const struct ts_poisson *problem)
{
	struct direct *d = self->state;

	ts_direct_release(&d->solver);
	if (ts_direct_make(&d->solver, problem, ts_pressure_team(sim, problem)) != TS_OK)
		return ts_nomem(&sim->error);
	if (ts_direct_divide(&d->solver, problem->slabs) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

static bool divided(const struct ts_instance *self)
{
	return ts_direct_divided(&((const struct direct *)self->state)->solver);
}

static enum ts_status solve(struct ts_instance *self, struct tsim *sim, const double *rhs, double *p,
			    struct ts_poisson_report *report)
{
	(void)sim;
	ts_direct_solve(&((struct direct *)self->state)->solver, rhs, p);
	*report = (struct ts_poisson_report){ .residual = NAN };
	return TS_OK;
}

static enum ts_status rehearse(struct ts_instance *self, int iterations)
{
	struct ts_direct *solver = &((struct direct *)self->state)->solver;

	(void)iterations;
	TS_TRY(ts_direct_divide(solver, solver->slabs));
	ts_direct_rehearse(solver);
	return TS_OK;
}

static double cost(const struct ts_instance *self, const struct ts_poisson *problem)
{
	(void)self;
	return ts_direct_cost(problem);
}

TS_STYLE(pressure, ts_pressure_style, ts_pressure_direct)
const struct ts_pressure_style ts_pressure_direct = {
	.style = { .name = "direct",
		   .kind = TS_KIND_PRESSURE,
		   .ranks = TS_RANKS_OWN | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
		   .summary = "direct solver by fast Fourier transforms and eigenvectors",
		   .doc = "The operator div grad of a Cartesian grid is a sum of one-dimensional operators.\n"
			  "Along all axes but one the pressure is expanded in their modes: waves, by fast\n"
			  "Fourier transforms, on uniform axes, and eigenvectors on graded ones. For each\n"
			  "mode a tridiagonal system along the last axis remains (R. W. Hockney, J. ACM 12\n"
			  "(1965) 95; R. E. Lynch, J. R. Rice and D. H. Thomas, Numer. Math. 6 (1964) 185).\n"
			  "The remaining divergence is round-off.\n\n"
			  "All boundary conditions and any number of cells are possible (fastest: products\n"
			  "of 2, 3 and 5). One graded axis adds no cost; each further one costs per cell as\n"
			  "many operations as it has cells. The void fraction must be 1 everywhere; for "
			  "beds\n"
			  "see pressure_style cg, which can use this solver as its preconditioner.",
		   .cite = "R. W. Hockney, J. ACM 12 (1965) 95",
		   .example = "pressure_style direct",
		   .state_size = sizeof(struct direct),
		   .fini = fini },
	.suits = suits,
	.prepare = prepare,
	.solve = solve,
	.divided = divided,
	.rehearse = rehearse,
	.cost = cost,
	.fields = 1,
};
