#include "immersed/solid.h"

#include <math.h>

#include "math/vec3.h"

#include "base/banned.h"

void ts_solid_rigid_velocity(const struct ts_solid_motion *motion, const double x[3],
			     struct ts_solid_surface *surface)
{
	double at[3] = { x[0], x[1], x[2] };

	if (surface->distance > 0)
		ts_axpy(-surface->distance, surface->n, at);
	ts_solid_velocity(motion, at, surface->v);
}

/* Place of x in cells from the lower end of the grid. */
static double cell_coordinate(const struct ts_grid *grid, int d, double x)
{
	const double *face = grid->face[d], *width = grid->width[d];
	int n = grid->n[d], i = x <= face[0] ? 0 : x >= face[n] ? n - 1 : ts_grid_find(grid, d, x);

	return i + (x - face[i]) / width[i];
}

double ts_solid_cells(const struct ts_grid *grid, const double lo[3], const double hi[3], int *axis)
{
	double least = INFINITY;

	for (int d = 0; d < grid->dimensions; d++) {
		double cells;

		if (!isfinite(lo[d]) || !isfinite(hi[d]))
			continue;
		cells = cell_coordinate(grid, d, hi[d]) - cell_coordinate(grid, d, lo[d]);
		if (!(cells < least))
			continue;
		least = cells;
		*axis = d;
	}
	return least;
}

void ts_solid_free(struct ts_solid *solid)
{
	if (!solid)
		return;
	if (solid->kind->release)
		solid->kind->release(solid);
	ts_free(solid->motion);
	ts_free(solid);
}
