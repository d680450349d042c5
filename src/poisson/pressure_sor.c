#include "poisson/poisson.h"

#include <math.h>

#include "poisson/pressure_style.h"
#include "poisson/relaxation.h"

#include "base/banned.h"

struct sor {
	struct ts_iteration iteration;
	double relaxation; /* omega; NaN: the optimal value */
	double omega;
	double *spare;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct sor *s = self->state;

	if (!(s->relaxation > 0 && s->relaxation < 2) && !isnan(s->relaxation))
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "relaxation"),
			       "relaxation %g: successive over-relaxation converges only between 0 and 2",
			       s->relaxation);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct sor *s = self->state;

	ts_iteration_release(&s->iteration);
	ts_stencil_field_free(s->spare);
	s->spare = NULL;
}

static enum ts_status prepare(struct ts_instance *self, struct tsim *sim, const struct ts_poisson *problem)
{
	struct sor *s = self->state;

	fini(self);
	TS_TRY(ts_iteration_prepare(&s->iteration, sim, problem));
	s->omega = isnan(s->relaxation) ? ts_relaxation_optimal(problem) : s->relaxation;
	s->spare = ts_stencil_field(&s->iteration.stencil);
	return s->spare ? TS_OK : ts_nomem(&sim->error);
}

static bool divided(const struct ts_instance *self)
{
	const struct sor *s = self->state;

	return ts_slabs_ranks(s->iteration.problem->slabs) > 1;
}

static enum ts_status solve(struct ts_instance *self, struct tsim *sim, const double *rhs, double *p,
			    struct ts_poisson_report *report)
{
	struct sor *s = self->state;
	struct ts_iteration *it = &s->iteration;
	double goal;

	it->stencil.slabs = divided(self) ? it->problem->slabs : NULL;
	TS_TRY(ts_iteration_begin(it, self, sim, rhs, p, &goal));
	*report = ts_relaxation_solve(&it->stencil, s->omega, it->b, it->p, s->spare, it->largest, goal,
				      (int)it->most);
	return ts_iteration_end(it, self, sim, goal, report, p);
}

static enum ts_status rehearse(struct ts_instance *self, int iterations)
{
	struct sor *s = self->state;
	struct ts_iteration *it = &s->iteration;

	it->stencil.slabs = divided(self) ? it->problem->slabs : NULL;
	ts_iteration_rehearse(it);
	ts_relaxation_rehearse(&it->stencil, it->p, iterations);
	return TS_OK;
}

/* Time of an iteration in ns per cell; iterations needed per digit: ln 10/(2 - omega), and a few more. */
static double cost(const struct ts_instance *self, const struct ts_poisson *problem)
{
	(void)self;
	return 6.5e-9 * (double)ts_grid_cells(problem->grid) * 18.4 / (2 - ts_relaxation_optimal(problem));
}

static const struct ts_arg args[] = {
	TS_ITERATION_ARGS(struct sor, iteration, "1e-8", "100000"),
	TS_REAL("relaxation", struct sor, relaxation, .flags = TS_OPTIONAL, .unit = "",
		.help = "relaxation factor omega, between 0 and 2; default: the optimal one of a uniform "
			"grid with as many cells"),
	TS_ARGS_END,
};

TS_STYLE(pressure, ts_pressure_style, ts_pressure_sor)
const struct ts_pressure_style ts_pressure_sor = {
	.style = { .name = "sor",
		   .kind = TS_KIND_PRESSURE,
		   .ranks = TS_RANKS_OWN | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
		   .summary = "successive over-relaxation in red-black order",
		   .doc = "Iterates over the cells in red-black order and changes each pressure by\n"
			  "`relaxation` times the change that would solve the equation of the cell. It\n"
			  "converges for values between 0 and 2; the optimal one is 2/(1 + sqrt(1 - "
			  "rho^2)),\n"
			  "with rho = 1 - q/sum(2/h^2) and q the smallest eigenvalue of -div grad: 2/(1 +\n"
			  "sin(pi/N)) for a square of N by N cells (D. M. Young, Trans. AMS 76 (1954) 92).\n"
			  "The number of iterations grows with N. This solver is a reference for the "
			  "others,\n"
			  "not a choice for large grids.",
		   .example = "pressure_style sor\npressure_style sor relaxation 1.7 tolerance 1e-6",
		   .cite = "D. M. Young, Trans. AMS 76 (1954) 92",
		   .args = args,
		   .state_size = sizeof(struct sor),
		   .init = init,
		   .fini = fini },
	.prepare = prepare,
	.solve = solve,
	.divided = divided,
	.rehearse = rehearse,
	.looks = TS_RELAXATION_LOOKS,
	.cost = cost,
	.fields = 7,
};
