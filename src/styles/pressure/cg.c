#include "flow/poisson.h"

#include "flow/conjugate.h"
#include "flow/pressure.h"

#include "base/banned.h"

struct cg {
	struct ts_iteration iteration;
	struct ts_conjugate conjugate;
};

static void fini(struct ts_instance *self)
{
	struct cg *cg = self->state;

	ts_iteration_release(&cg->iteration);
	ts_conjugate_release(&cg->conjugate);
}

static bool suits(const struct ts_instance *self, const struct ts_poisson *problem, const char **why)
{
	(void)self;
	(void)problem;
	(void)why;
	return true;
}

static enum ts_status prepare(struct ts_instance *self, struct tsim *sim,
			      const struct ts_poisson *problem)
{
	struct cg *cg = self->state;

	ts_conjugate_release(&cg->conjugate);
	TS_TRY(ts_iteration_prepare(&cg->iteration, sim, problem));
	if (ts_conjugate_make(&cg->conjugate, &cg->iteration.stencil) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

static enum ts_status solve(struct ts_instance *self, struct tsim *sim, const double *rhs, double *p,
			    struct ts_poisson_report *report)
{
	struct cg *cg = self->state;
	struct ts_iteration *it = &cg->iteration;
	double goal;

	TS_TRY(ts_iteration_begin(it, self, sim, rhs, p, &goal));
	*report = ts_conjugate_solve(&cg->conjugate, &it->stencil, NULL, NULL, it->b, it->p, goal,
				     (int)it->most);
	return ts_iteration_end(it, self, sim, goal, report, p);
}

static double cost(const struct ts_instance *self, const struct ts_poisson *problem)
{
	const int *n = problem->grid->n;
	int longest = n[0] > n[1] ? n[0] : n[1];

	(void)self;
	longest = n[2] > longest ? n[2] : longest;
	return 3.0 * longest * 1e-8 * (double)ts_grid_cells(problem->grid);
}

static const struct ts_arg args[] = {
	TS_ITERATION_ARGS(struct cg, iteration, "1e-8", "10000"),
	TS_ARGS_END,
};

TS_STYLE(pressure, ts_pressure_style, ts_pressure_cg)
const struct ts_pressure_style ts_pressure_cg = {
	.style = { .name = "cg",
		   .kind = TS_KIND_PRESSURE,
		   .summary = "conjugate gradients",
		   .doc = "Solves for the pressure by conjugate gradients.",
		   .example = "pressure_style cg tolerance 1e-8",
		   .args = args,
		   .state_size = sizeof(struct cg),
		   .fini = fini },
	.suits = suits,
	.prepare = prepare,
	.solve = solve,
	.cost = cost,
};
