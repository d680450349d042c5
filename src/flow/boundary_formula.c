/* Evaluation of the formulas of flow_boundary at the points of a face of the grid. */
#include <math.h>

#include "flow/boundary.h"
#include "flow/flow_arguments.h"

#include "base/banned.h"

double ts_flow_coordinate(const struct ts_grid *grid, int a, int c, int i)
{
	int n = grid->n[a], last = c == a ? n : n - 1;

	if (grid->periodic[a])
		i = ((i % n) + n) % n;
	i = i < 0 ? 0 : i > last ? last : i;
	return c == a ? grid->face[a][i] : grid->centre[a][i];
}

enum ts_status ts_flow_formula_value(struct tsim *sim, const struct ts_flow_condition *condition,
				     const struct ts_flow_formula *formula, double *out)
{
	TS_TRY(ts_number_now(sim, formula->number, &condition->where, out));
	if (!isfinite(*out))
		return ts_fail(&sim->error, TS_RANGE, &condition->where,
			       "flow_boundary: the %s v_%s is %g, which is not a finite number",
			       formula->what, formula->number->variable, *out);
	return TS_OK;
}

enum ts_status ts_flow_fill_plane(struct tsim *sim, const struct ts_flow_condition *condition,
				  const struct ts_flow_formula *formula, const struct ts_grid *grid, int d,
				  enum ts_grid_side side, double *plane)
{
	int a = d == 0, b = d == 2 ? 1 : 2;
	double x[3];

	x[d] = grid->face[d][side == TS_LOW ? 0 : grid->n[d]];
	for (int ib = -grid->ghosts[b]; ib <= grid->n[b] + grid->ghosts[b] - 1; ib++)
		for (int ia = -grid->ghosts[a]; ia <= grid->n[a] + grid->ghosts[a] - 1; ia++) {
			x[a] = ts_flow_coordinate(grid, a, formula->component, ia);
			x[b] = ts_flow_coordinate(grid, b, formula->component, ib);
			TS_TRY(ts_flow_set_coordinates(sim, condition->set, x, &condition->where));
			TS_TRY(ts_flow_formula_value(sim, condition, formula,
						     &plane[ts_flow_plane_at(grid, d, ia, ib)]));
		}
	return TS_OK;
}
