#include "poisson/pressure_style.h"

#include <math.h>

#include "base/banned.h"

const char *const ts_iteration_unfinished_names[] = { "stop", "warn", NULL };

int ts_pressure_team(const struct tsim *sim, const struct ts_poisson *problem)
{
	int team = ts_team(sim, ts_grid_cells(problem->grid));

	return team < problem->threads ? team : problem->threads;
}

enum ts_status ts_iteration_prepare(struct ts_iteration *it, struct tsim *sim,
				    const struct ts_poisson *problem)
{
	ts_iteration_release(it);
	it->problem = problem;
	it->weighed = false;
	if (ts_stencil_make(&it->stencil, problem) != TS_OK)
		return ts_nomem(&sim->error);
	it->stencil.threads = ts_pressure_team(sim, problem);
	it->b = ts_stencil_field(&it->stencil);
	it->p = ts_stencil_field(&it->stencil);
	return it->b && it->p ? TS_OK : ts_nomem(&sim->error);
}

void ts_iteration_release(struct ts_iteration *it)
{
	ts_stencil_release(&it->stencil);
	ts_stencil_field_free(it->b);
	ts_stencil_field_free(it->p);
	it->b = it->p = NULL;
}

enum ts_status ts_iteration_begin(struct ts_iteration *it, struct ts_instance *self, struct tsim *sim,
				  const double *rhs, const double *p, double *goal)
{
	struct ts_stencil *s = &it->stencil;

	it->changed = it->problem->weight[0] || !it->weighed || (it->part && ts_slabs_ranks(s->slabs) == 1);
	if (it->changed) {
		ts_stencil_set_weights(s, it->problem);
		it->part = ts_slabs_ranks(s->slabs) > 1;
	}
	it->weighed = !it->problem->weight[0];
	ts_stencil_from_grid(s, it->problem->grid, rhs, true, it->b);
	if (it->problem->singular)
		ts_stencil_balance(s, it->b);
	it->largest = ts_stencil_largest(s, it->b);
	if (!isfinite(it->largest))
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "the fluid's velocities are not finite: use a smaller time step");
	*goal = it->tolerance * it->largest;
	if (it->largest > 0)
		ts_stencil_from_grid(s, it->problem->grid, p, false, it->p);
	else
		ts_stencil_clear(s, it->p);
	return TS_OK;
}

void ts_iteration_rehearse(struct ts_iteration *it)
{
	struct ts_stencil *s = &it->stencil;

	ts_stencil_max_rows(s);
	if (it->problem->singular) { /* balanced before, centred afterwards */
		ts_stencil_sum_rows(s);
		ts_stencil_sum_rows(s);
	}
}

enum ts_status ts_iteration_end(struct ts_iteration *it, struct ts_instance *self, struct tsim *sim,
				double goal, const struct ts_poisson_report *report, double *p)
{
	const char *name = self->style->name;
	double left = report->residual / it->largest;

	if (it->problem->singular)
		ts_stencil_centre(&it->stencil, it->p);
	ts_stencil_to_grid(&it->stencil, it->problem->grid, it->p, p);
	if (goal == 0 || report->residual <= goal)
		return TS_OK;
	if (!isfinite(report->residual) || it->unfinished == TS_UNFINISHED_STOP)
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "pressure_style %s: after %d iterations the residual is %.3g of the largest "
			       "right-hand side, not %g; give it more iterations, a larger tolerance, or "
			       "choose another pressure_style",
			       name, report->iterations, left, it->tolerance);
	if (!it->warned)
		ts_warn(&sim->log, &self->where,
			"pressure_style %s: after %d iterations the residual is %.3g of the largest "
			"right-hand side, not %g; later ones are not reported",
			name, report->iterations, left, it->tolerance);
	it->warned = true;
	return TS_OK;
}
