#include "poisson/poisson.h"

#include "poisson/preconditioned_cg.h"

#include "base/banned.h"

static enum ts_status prepare(struct ts_instance *self, struct tsim *sim, const struct ts_poisson *problem)
{
	((struct ts_preconditioned *)self->state)->wanted = TS_PRECONDITION_MULTIGRID;
	return ts_preconditioned_prepare(self, sim, problem);
}

static double cost(const struct ts_instance *self, const struct ts_poisson *problem)
{
	const struct ts_preconditioned multigrid = { .wanted = TS_PRECONDITION_MULTIGRID };

	(void)self;
	return ts_preconditioned_cost(&multigrid, problem);
}

static const struct ts_arg args[] = {
	TS_ITERATION_ARGS(struct ts_preconditioned, iteration, "1e-8", "500"),
	TS_ARGS_END,
};

TS_STYLE(pressure, ts_pressure_style, ts_pressure_multigrid)
const struct ts_pressure_style ts_pressure_multigrid = {
	.style = { .name = "multigrid",
		   .kind = TS_KIND_PRESSURE,
		   .summary = "geometric multigrid within conjugate gradients",
		   .doc = "Solves for the pressure by V-cycles over coarser and coarser grids (A. Brandt, "
			  "Math. Comp. 31 (1977) 333), each the preconditioner of an iteration of conjugate "
			  "gradients (O. Tatebe, NASA CP-3224 (1993) 621). Any number of cells serves; cells "
			  "are joined in pairs along the axes on which they are narrow. Smoothing is by red "
			  "and black Gauss-Seidel. The work for each cell hardly depends on how many there "
			  "are; void fractions may differ by orders of magnitude.",
		   .example = "pressure_style multigrid tolerance 1e-8",
		   .cite = "A. Brandt, Math. Comp. 31 (1977) 333",
		   .args = args,
		   .state_size = sizeof(struct ts_preconditioned),
		   .fini = ts_preconditioned_fini },
	.prepare = prepare,
	.solve = ts_preconditioned_solve,
	.cost = cost,
	.fields = 12,
};
