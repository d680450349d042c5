#include "poisson/poisson.h"

#include "poisson/preconditioned_cg.h"

#include "base/banned.h"

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	if (!ts_hypre_available())
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "this tsim was built without hypre: configure it with --with-hypre, or use "
			       "pressure_style multigrid, its own");
	if (((const struct ts_preconditioned *)self->state)->ranks && sim->world &&
	    (!ts_hypre_divides() || !sim->world->communicator))
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "ranks"),
			       "this tsim was built with a hypre without MPI, so that ranks cannot divide "
			       "its "
			       "grid: leave out `ranks yes`, with which each rank solves the whole grid, or "
			       "use "
			       "pressure_style multigrid, which they divide");
	return TS_OK;
}

static bool suits(const struct ts_poisson *problem, const char **why)
{
	if (!ts_hypre_available()) {
		*why = "this tsim was built without hypre";
		return false;
	}
	for (int d = 0; d < problem->grid->dimensions; d++) {
		int n = problem->grid->n[d];

		*why = "hypre's multigrid wants a power of two of cells along periodic axes";
		if (problem->condition[d][0] == TS_PRESSURE_PERIODIC && (n & (n - 1)))
			return false;
	}
	return true;
}

static enum ts_status prepare(struct ts_instance *self, struct tsim *sim, const struct ts_poisson *problem)
{
	((struct ts_preconditioned *)self->state)->wanted = TS_PRECONDITION_HYPRE;
	return ts_preconditioned_prepare(self, sim, problem);
}

static double cost(const struct ts_instance *self, const struct ts_poisson *problem)
{
	const struct ts_preconditioned hypre = { .wanted = TS_PRECONDITION_HYPRE };

	(void)self;
	return ts_preconditioned_cost(&hypre, problem);
}

static const struct ts_arg args[] = {
	TS_ITERATION_ARGS(struct ts_preconditioned, iteration, "1e-8", "500"),
	TS_BOOL("ranks", struct ts_preconditioned, ranks, .fallback = "no",
		.help = "whether several ranks divide the grid of hypre; digits may depend on their number "
			"then, within `tolerance`"),
	TS_ARGS_END,
};

TS_STYLE(pressure, ts_pressure_style, ts_pressure_hypre)
const struct ts_pressure_style ts_pressure_hypre = {
	.style = { .name = "hypre",
		   .kind = TS_KIND_PRESSURE,
		   .ranks = TS_RANKS_OWN | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
		   .summary = "conjugate gradients with the multigrid preconditioner of the library hypre",
		   .doc = "The iteration of pressure_style cg, with one V-cycle of PFMG of hypre as the\n"
			  "preconditioner: semi-coarsening with Galerkin operators. This cycle is not\n"
			  "symmetric on all grids: directions are those of the flexible method (Notay "
			  "2000).\n"
			  "It is about as fast as\n"
			  "pressure_style multigrid (doc/pressure.md).\n\n"
			  "Available if tsim was configured with --with-hypre. hypre needs MPI, which is\n"
			  "initialized for the one process when the style is first used. The number of "
			  "cells\n"
			  "along periodic axes must be a power of two. The solver uses one thread.\n"
			  "With several ranks each solves the whole grid, and so gets the bits of one "
			  "process.\n"
			  "With `ranks yes` they divide it: each has a slab of all levels, as of the rest of "
			  "a "
			  "step\n"
			  "(doc/ranks.md), for grids too large for one. Pressures then agree with those of "
			  "one "
			  "rank to\n"
			  "`tolerance`: hypre does not promise bits that do not depend on the number of "
			  "ranks "
			  "(in the\n"
			  "grids of the tests they are the same).",
		   .example = "pressure_style hypre\npressure_style hypre ranks yes tolerance 1e-10",
		   .cite = "R. D. Falgout and J. E. Jones, Multigrid Methods VI (2000) 101",
		   .args = args,
		   .state_size = sizeof(struct ts_preconditioned),
		   .init = init,
		   .fini = ts_preconditioned_fini },
	.suits = suits,
	.prepare = prepare,
	.solve = ts_preconditioned_solve,
	.divided = ts_preconditioned_divided,
	.always_divided = ts_preconditioned_always_divided,
	.cost = cost,
	.fields = 25,
};
