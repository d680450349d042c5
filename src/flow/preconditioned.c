#include "flow/preconditioned.h"

#include <string.h>

#include "base/banned.h"

const char *const ts_preconditioner_names[] = { "auto", "diagonal", "direct", "multigrid", NULL };

enum ts_preconditioner ts_precondition_choose(int wanted, const struct ts_poisson *problem)
{
	if (wanted != TS_PRECONDITION_AUTO)
		return (enum ts_preconditioner)wanted;
	(void)problem;
	return TS_PRECONDITION_DIRECT;
}

void ts_preconditioned_release(struct ts_preconditioned *c)
{
	ts_iteration_release(&c->iteration);
	ts_conjugate_release(&c->conjugate);
	ts_direct_release(&c->direct);
	ts_multigrid_release(&c->multigrid);
}

enum ts_status ts_preconditioned_prepare(struct ts_preconditioned *c, struct tsim *sim,
					 const struct ts_poisson *problem)
{
	const struct ts_stencil *s = &c->iteration.stencil;
	enum ts_status status;

	ts_preconditioned_release(c);
	TS_TRY(ts_iteration_prepare(&c->iteration, sim, problem));
	c->preconditioner = ts_precondition_choose(c->wanted, problem);
	status = ts_conjugate_make(&c->conjugate, s);
	if (status == TS_OK && c->preconditioner == TS_PRECONDITION_DIRECT)
		status = ts_direct_make(&c->direct, problem, s->threads);
	if (status == TS_OK && c->preconditioner == TS_PRECONDITION_MULTIGRID)
		status = ts_multigrid_make(&c->multigrid, s);
	if (status != TS_OK)
		return ts_nomem(&sim->error);
	c->direct.origin = s->origin;
	memcpy(c->direct.stride, s->stride, sizeof s->stride);
	return TS_OK;
}

/* z = L^-1 (r/V), L the operator without weights: V L is symmetric. */
static void without_weights(void *context, const double *r, double *z)
{
	struct ts_preconditioned *c = context;

	ts_stencil_by_volume(&c->iteration.stencil, r, z);
	ts_direct_solve(&c->direct, z, z);
}

enum ts_status ts_preconditioned_solve(struct ts_preconditioned *c, struct ts_instance *self,
				       struct tsim *sim, const double *rhs, double *p,
				       struct ts_poisson_report *report)
{
	struct ts_iteration *it = &c->iteration;
	ts_precondition_fn *precondition = NULL;
	void *context = c;
	double goal;

	TS_TRY(ts_iteration_begin(it, self, sim, rhs, p, &goal));
	if (c->preconditioner == TS_PRECONDITION_DIRECT)
		precondition = without_weights;
	if (c->preconditioner == TS_PRECONDITION_MULTIGRID) {
		if (it->changed)
			ts_multigrid_weigh(&c->multigrid);
		precondition = ts_multigrid_cycle;
		context = &c->multigrid;
	}
	*report = ts_conjugate_solve(&c->conjugate, &it->stencil, precondition, context, it->b, it->p, goal,
				     (int)it->most);
	return ts_iteration_end(it, self, sim, goal, report, p);
}
