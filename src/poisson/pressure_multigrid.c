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
		   .ranks = TS_RANKS_OWN | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
		   .summary = "conjugate gradients with a geometric multigrid preconditioner",
		   .doc = "Solves for the pressure by conjugate gradients, preconditioned (O. Tatebe, NASA\n"
			  "CP-3224 (1993) 621) by one V-cycle over successively coarser grids (A. Brandt,\n"
			  "Math. Comp. 31 (1977) 333). Any number of cells is possible; cells are merged in\n"
			  "pairs along the axes on which they are narrow. The smoother is Gauss-Seidel in\n"
			  "red-black order. The work per cell hardly depends on the number of cells; void\n"
			  "fractions may differ by orders of magnitude.",
		   .example = "pressure_style multigrid tolerance 1e-8",
		   .cite = "A. Brandt, Math. Comp. 31 (1977) 333",
		   .args = args,
		   .state_size = sizeof(struct ts_preconditioned),
		   .fini = ts_preconditioned_fini },
	.prepare = prepare,
	.solve = ts_preconditioned_solve,
	.divided = ts_preconditioned_divided,
	.always_divided = ts_preconditioned_always_divided,
	.rehearse = ts_preconditioned_rehearse,
	.looks = 1,
	.cost = cost,
	.fields = 12,
};
