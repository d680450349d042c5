#include "poisson/poisson.h"

#include "poisson/preconditioned_cg.h"

#include "base/banned.h"

static double cost(const struct ts_instance *self, const struct ts_poisson *problem)
{
	return ts_preconditioned_cost(self ? self->state : NULL, problem);
}

static const struct ts_arg args[] = {
	TS_ITERATION_ARGS(struct ts_preconditioned, iteration, "1e-8", "10000"),
	TS_ENUM("preconditioner", struct ts_preconditioned, wanted, ts_preconditioner_names,
		.fallback = "auto", .help = "preconditioner"),
	TS_ARGS_END,
};

TS_STYLE(pressure, ts_pressure_style, ts_pressure_cg)
const struct ts_pressure_style ts_pressure_cg = {
	.style = { .name = "cg",
		   .kind = TS_KIND_PRESSURE,
		   .ranks = TS_RANKS_OWN | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
		   .summary = "conjugate gradient method",
		   .doc = "Solves for the pressure by preconditioned conjugate gradients (M. R. Hestenes "
			  "and\n"
			  "E. Stiefel, J. Res. Nat. Bur. Stand. 49 (1952) 409), for any void fraction and\n"
			  "any grid.\n\n"
			  "Preconditioners: `diagonal` is cheap, but the number of iterations grows with "
			  "the\n"
			  "number of cells along an axis. `direct` is the solution of the problem without\n"
			  "void fraction by pressure_style direct: the number of iterations depends only on\n"
			  "the ratio of the largest to the smallest weight of a face (about 10 iterations\n"
			  "for a packed bed under free fluid). `multigrid` is the cycle of pressure_style\n"
			  "multigrid, for weights that differ by orders of magnitude, as with a strong\n"
			  "semi-implicit drag. `auto` selects for each solve `direct`, or `multigrid` if "
			  "the\n"
			  "ratio is above 30, where it was measured to be faster.\n\n"
			  "The initial guess is the pressure of the previous step. The iteration ends when\n"
			  "the largest residual is below `tolerance` times the largest right-hand side.",
		   .example = "pressure_style cg tolerance 1e-8\npressure_style cg preconditioner direct",
		   .cite = "M. R. Hestenes and E. Stiefel, J. Res. Nat. Bur. Stand. 49 (1952) 409",
		   .args = args,
		   .state_size = sizeof(struct ts_preconditioned),
		   .fini = ts_preconditioned_fini },
	.prepare = ts_preconditioned_prepare,
	.solve = ts_preconditioned_solve,
	.divided = ts_preconditioned_divided,
	.always_divided = ts_preconditioned_always_divided,
	.rehearse = ts_preconditioned_rehearse,
	.looks = 1,
	.cost = cost,
	.fields = 13,
};
