#include "poisson/poisson.h"

#include "base/banned.h"

double ts_poisson_conductance(const struct ts_poisson *problem, int d, int i)
{
	const struct ts_grid *grid = problem->grid;
	int n = grid->n[d];
	enum ts_pressure_condition condition;

	if (d >= grid->dimensions)
		return 0;
	if (i > 0 && i < n)
		return 1 / grid->gap[d][i];
	condition = problem->condition[d][i > 0];
	if (condition == TS_PRESSURE_PERIODIC) /* a single cell is its own neighbour: no flux */
		return n == 1 ? 0 : 2 / (grid->width[d][0] + grid->width[d][n - 1]);
	return condition == TS_PRESSURE_GIVEN ? 2 / grid->width[d][i > 0 ? n - 1 : 0] : 0;
}

static double face_weight(const struct ts_poisson *problem, int d, size_t at)
{
	return problem->weight[d] ? problem->weight[d][at] : 1;
}

/* The flux across the lower face `i` of axis d, for the cell at `at` with index i there. The last face of
 * a periodic axis is the first one. */
static double face_flux(const struct ts_poisson *problem, const double *p, int d, int i, size_t at)
{
	const struct ts_grid *grid = problem->grid;
	ptrdiff_t stride = grid->stride[d];
	int n = grid->n[d];
	bool wraps = problem->condition[d][0] == TS_PRESSURE_PERIODIC;
	size_t first = (size_t)((ptrdiff_t)at - i * stride), face = wraps && i == n ? first : at;
	double conduct = ts_poisson_conductance(problem, d, i), below, above;

	if (conduct == 0)
		return 0;
	below = i > 0 ? p[(ptrdiff_t)at - stride] : wraps ? p[(ptrdiff_t)first + (n - 1) * stride] : 0;
	above = i < n ? p[at] : wraps ? p[first] : 0;
	return face_weight(problem, d, face) * conduct * (above - below);
}

static void apply_row(const struct ts_poisson *problem, const double *p, double *out, int j, int k)
{
	const struct ts_grid *grid = problem->grid;

	for (int i = 0; i < grid->n[0]; i++) {
		size_t at = ts_at(grid, i, j, k);
		const int index[3] = { i, j, k };
		double sum = 0;

		for (int d = 0; d < grid->dimensions; d++)
			sum += (face_flux(problem, p, d, index[d] + 1, at + (size_t)grid->stride[d]) -
				face_flux(problem, p, d, index[d], at)) /
			       grid->width[d][index[d]];
		out[at] = sum;
	}
}

void ts_poisson_apply(const struct ts_poisson *problem, const double *p, double *out)
{
	const struct ts_grid *grid = problem->grid;
	int rows = grid->n[1] * grid->n[2];

#pragma omp parallel for num_threads(problem->threads) schedule(static)
	for (int row = 0; row < rows; row++)
		apply_row(problem, p, out, row % grid->n[1], row / grid->n[1]);
}
