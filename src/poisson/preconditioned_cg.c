#include "poisson/preconditioned_cg.h"

#include <math.h>
#include <string.h>

#include "poisson/direct_exchange.h"

#include "base/banned.h"

const char *const ts_preconditioner_names[] = { "auto", "diagonal", "direct", "multigrid", NULL };

/* Ratio of weights above which multigrid is faster, by measurement (doc/pressure.md): with the direct
 * solver the iterations for 8 digits are 11 for a ratio of 2.5, 29 for 30, 40 for 100; with multigrid 11
 * to 14, each of twice the time. */
static const double CONTRAST = 30;

struct weight_range {
	double least, most;
};

/* Of the faces across axis d that the flow can cross, in the rows of this rank. */
static struct weight_range range_of_weights(const struct ts_stencil *s, const struct ts_poisson *problem,
					    int d)
{
	double most = 0, least = INFINITY;
	int last[3] = { s->n[0], s->n[1], s->n[2] };
	long first, end;

	for (int a = 0; a < 3; a++)
		last[a] -= a != d || s->conductance[d][s->n[d]] == 0;
	ts_slabs_rows(problem->apart ? problem->slabs : NULL, s->n[2], last[1] + 1, last[2] + 1 - s->n[2],
		      &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static) reduction(max : most) reduction(min : least)
	for (long row = first; row < end; row++) {
		int j = (int)(row % (last[1] + 1)), k = (int)(row / (last[1] + 1));
		const double *w = problem->weight[d] + ts_at(problem->grid, 0, j, k);

		if ((d == 1 && s->conductance[1][j] == 0) || (d == 2 && s->conductance[2][k] == 0))
			continue;
		for (int i = d == 0 && s->conductance[0][0] == 0; i <= last[0]; i++) {
			most = w[i] > most ? w[i] : most;
			least = w[i] < least ? w[i] : least;
		}
	}
	return (struct weight_range){ least, most };
}

/* Ratio of the largest to the smallest weight of faces that the flow can cross; INFINITY if the smallest
 * is 0. */
static double weight_ratio(const struct ts_stencil *s, const struct ts_poisson *problem)
{
	double most[2] = { 0, -INFINITY }; /* largest, and the smallest with another sign */

	for (int d = 0; d < s->axes && problem->weight[d]; d++) {
		const struct weight_range range = range_of_weights(s, problem, d);

		most[0] = fmax(most[0], range.most);
		most[1] = fmax(most[1], -range.least);
	}
	if (problem->apart)
		ts_world_most(problem->slabs->world, most, 2);
	return most[0] > 0 ? most[0] / -most[1] : 1;
}

double ts_preconditioned_cost(const struct ts_preconditioned *c, const struct ts_poisson *problem)
{
	double cells = (double)ts_grid_cells(problem->grid);
	int wanted = c ? c->wanted : TS_PRECONDITION_AUTO;
	int longest = 0;

	for (int d = 0; d < 3; d++)
		longest = problem->grid->n[d] > longest ? problem->grid->n[d] : longest;
	if (wanted == TS_PRECONDITION_HYPRE)
		return 14 * 36e-9 * cells;
	if (wanted == TS_PRECONDITION_MULTIGRID)
		return 13 * 30e-9 * cells;
	if (wanted == TS_PRECONDITION_DIAGONAL)
		return 5 * longest * 6.5e-9 * cells;
	return (problem->weight[0] ? 11 : 2) * (ts_direct_cost(problem) + 9e-9 * cells);
}

void ts_preconditioned_fini(struct ts_instance *self)
{
	struct ts_preconditioned *c = self->state;

	ts_iteration_release(&c->iteration);
	ts_conjugate_gradient_release(&c->conjugate);
	ts_direct_release(&c->direct);
	ts_multigrid_release(&c->multigrid);
	ts_hypre_release(c->hypre);
	c->hypre = NULL;
}

/* The ranks that divide the grid of hypre; NULL: none. */
static struct ts_world *ranks_of_hypre(const struct ts_preconditioned *c, const struct ts_poisson *problem)
{
	struct ts_world *world = problem->slabs ? problem->slabs->world : NULL;

	return c->ranks && world && world->communicator && problem->grid->n[2] >= world->n ? world : NULL;
}

enum ts_status ts_preconditioned_prepare(struct ts_instance *self, struct tsim *sim,
					 const struct ts_poisson *problem)
{
	struct ts_preconditioned *c = self->state;
	const struct ts_stencil *s = &c->iteration.stencil;
	bool any = c->wanted == TS_PRECONDITION_AUTO;
	enum ts_status status;

	ts_preconditioned_fini(self);
	TS_TRY(ts_iteration_prepare(&c->iteration, sim, problem));
	status = ts_conjugate_gradient_make(&c->conjugate, s);
	if (status == TS_OK && (any || c->wanted == TS_PRECONDITION_DIRECT))
		status = ts_direct_make(&c->direct, problem, s->threads);
	if (status == TS_OK && ((any && problem->weight[0]) || c->wanted == TS_PRECONDITION_MULTIGRID))
		status = ts_multigrid_make(&c->multigrid, s, problem->slabs);
	if (status == TS_OK && c->wanted == TS_PRECONDITION_HYPRE &&
	    !(c->hypre = ts_hypre_make(s, ranks_of_hypre(c, problem))))
		status = TS_NOMEM;
	if (status != TS_OK)
		return ts_nomem(&sim->error);
	if (ts_direct_divide(&c->direct, problem->slabs) != TS_OK)
		return ts_nomem(&sim->error);
	c->direct.origin = s->origin;
	memcpy(c->direct.stride, s->stride, sizeof s->stride);
	return TS_OK;
}

/* The preconditioner of the next solve. */
static int choose_preconditioner(const struct ts_preconditioned *c, const struct ts_poisson *problem)
{
	if (c->wanted != TS_PRECONDITION_AUTO)
		return c->wanted;
	return c->multigrid.levels && weight_ratio(&c->iteration.stencil, problem) > CONTRAST
		       ? TS_PRECONDITION_MULTIGRID
		       : TS_PRECONDITION_DIRECT;
}

static bool divides(const struct ts_preconditioned *c, int kind)
{
	return kind == TS_PRECONDITION_DIAGONAL ||
	       (kind == TS_PRECONDITION_MULTIGRID && c->multigrid.divided) ||
	       (kind == TS_PRECONDITION_HYPRE && ranks_of_hypre(c, c->iteration.problem)) ||
	       (kind == TS_PRECONDITION_DIRECT && ts_direct_divided(&c->direct));
}

/* Where the weights choose, they choose anew before each solve. */
bool ts_preconditioned_always_divided(const struct ts_instance *self)
{
	const struct ts_preconditioned *c = self->state;

	if (ts_slabs_ranks(c->iteration.problem->slabs) == 1)
		return false;
	if (c->wanted != TS_PRECONDITION_AUTO)
		return divides(c, c->wanted);
	return divides(c, TS_PRECONDITION_DIRECT) &&
	       (!c->multigrid.levels || divides(c, TS_PRECONDITION_MULTIGRID));
}

bool ts_preconditioned_divided(const struct ts_instance *self)
{
	const struct ts_preconditioned *c = self->state;
	const struct ts_poisson *problem = c->iteration.problem;

	if (ts_slabs_ranks(problem->slabs) == 1)
		return false;
	return problem->apart || divides(c, choose_preconditioner(c, problem));
}

/* z = L^-1 (r/V), L the operator without weights: V L is symmetric. */
static void precondition_by_direct(void *context, const double *r, double *z)
{
	struct ts_preconditioned *c = context;

	ts_stencil_per_volume(&c->iteration.stencil, r, z);
	ts_direct_solve(&c->direct, z, z);
}

static void rehearse_direct(void *context, const double *r, double *z)
{
	const struct ts_preconditioned *c = context;

	(void)r;
	(void)z;
	ts_direct_rehearse(&c->direct);
}

enum ts_status ts_preconditioned_rehearse(struct ts_instance *self, int iterations)
{
	struct ts_preconditioned *c = self->state;
	struct ts_iteration *it = &c->iteration;
	struct ts_poisson whole = *it->problem;
	int kind;

	whole.apart = false; /* this process has all weights */
	kind = choose_preconditioner(c, &whole);
	it->stencil.slabs = ts_preconditioned_divided(self) ? it->problem->slabs : NULL;
	TS_TRY(ts_direct_divide(&c->direct, c->direct.slabs));
	ts_iteration_rehearse(it);
	if (kind == TS_PRECONDITION_MULTIGRID && it->problem->weight[0])
		ts_multigrid_rehearse_weights(&c->multigrid);
	if (kind == TS_PRECONDITION_MULTIGRID)
		ts_conjugate_gradient_rehearse(&c->conjugate, &it->stencil, ts_multigrid_cycle, &c->multigrid,
					       iterations);
	else
		ts_conjugate_gradient_rehearse(&c->conjugate, &it->stencil,
					       kind == TS_PRECONDITION_DIRECT ? rehearse_direct : NULL, c,
					       iterations);
	return TS_OK;
}

enum ts_status ts_preconditioned_solve(struct ts_instance *self, struct tsim *sim, const double *rhs,
				       double *p, struct ts_poisson_report *report)
{
	struct ts_preconditioned *c = self->state;
	struct ts_iteration *it = &c->iteration;
	ts_precondition_fn *precondition = NULL;
	void *context = c;
	int kind = choose_preconditioner(c, it->problem);
	double goal;

	/* PFMG leaves out the smoothing of some levels, and is not symmetric then */
	c->conjugate.flexible = kind == TS_PRECONDITION_HYPRE;
	it->stencil.slabs = ts_preconditioned_divided(self) ? it->problem->slabs : NULL;
	TS_TRY(ts_iteration_begin(it, self, sim, rhs, p, &goal));
	if (kind == TS_PRECONDITION_DIRECT)
		precondition = precondition_by_direct;
	if (kind == TS_PRECONDITION_MULTIGRID) {
		if (it->changed)
			ts_multigrid_set_weights(&c->multigrid);
		precondition = ts_multigrid_cycle;
		context = &c->multigrid;
	}
	if (kind == TS_PRECONDITION_HYPRE) {
		if (it->changed && ts_hypre_set_weights(c->hypre) != TS_OK)
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "hypre cannot make a multigrid for this grid: choose another "
				       "pressure_style");
		precondition = ts_hypre_cycle;
		context = c->hypre;
	}
	*report = ts_conjugate_gradient_solve(&c->conjugate, &it->stencil, precondition, context, it->b,
					      it->p, it->largest, goal, (int)it->most);
	return ts_iteration_end(it, self, sim, goal, report, p);
}
