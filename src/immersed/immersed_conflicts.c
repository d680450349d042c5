/* Boundaries and bodies that meet in one place with different velocities: no fluid is there, but the force on a
 * body contains their friction. */
#include <math.h>

#include "flow/flow_measures.h"
#include "flow/fluid_slabs.h"
#include "immersed/immersed.h"

#include "base/banned.h"

/* Relative difference of velocities that is not round-off. */
static const double UNEQUAL = 1e-9;

static bool differ(double a, double b)
{
	return fabs(a - b) > UNEQUAL * (fabs(a) + fabs(b));
}

/* Velocity of component c on the wall beside a cell. */
static double wall_velocity(const struct ts_fluid *fluid, int c, int d, int side, const int i[3])
{
	const struct ts_flow_face_velocity *given = &fluid->face_velocity[d][side];
	int a = d == 0, b = d == 2 ? 1 : 2;

	return given->plane[c] ? given->plane[c][ts_flow_plane_at(&fluid->grid, d, i[a], i[b])]
			       : given->constant[c];
}

/* Whether the body covers a part of this wall on which the velocity along it is not that of the body. */
static bool rubs_on_wall(const struct ts_immersed *ib, const struct ts_fluid *fluid, int d, int side)
{
	const struct ts_grid *grid = &fluid->grid;

	for (int c = 0; c < grid->dimensions; c++)
		for (size_t k = ib->first[c]; c != d && k < ib->first[c + 1]; k++) {
			const struct ts_immersed_point *p = &ib->point[k];
			int i[3];

			ts_grid_indices(grid, p->at, i);
			if (!p->outside && i[d] == (side ? grid->n[d] - 1 : 0) &&
			    differ(p->target, wall_velocity(fluid, c, d, side, i)))
				return true;
		}
	return false;
}

void ts_immersed_warn_walls(struct tsim *sim, const struct ts_place *where, const struct ts_immersed *ib,
			    const struct ts_fluid *fluid)
{
	for (int face = 0; face < 2 * fluid->grid.dimensions; face++)
		if (fluid->face[face / 2][face % 2] == TS_FLOW_WALL &&
		    ts_fluid_slabs_most(fluid, rubs_on_wall(ib, fluid, face / 2, face % 2)) > 0)
			ts_warn(&sim->log, where,
				"fix immersed/boundary: the body covers a part of the wall %s, which has "
				"another velocity than the body: the force on the body contains their "
				"friction; use `flow_boundary %s slip`",
				ts_flow_face_names[face], ts_flow_face_names[face]);
}

enum ts_status ts_immersed_overlap(const struct ts_immersed *a, const struct ts_immersed *b,
				   const struct ts_fluid *fluid, size_t *points)
{
	double *target = ts_alloc(fluid->grid.size, sizeof *target);
	size_t first, end;
	int64_t number = 0;

	if (!target)
		return TS_NOMEM;
	ts_fluid_slabs_values(fluid, &first, &end);
	for (int c = 0; c < fluid->grid.dimensions; c++) {
		for (size_t k = first; k < end; k++)
			target[k] = NAN;
		for (size_t k = a->first[c]; k < a->first[c + 1]; k++)
			if (!a->point[k].outside)
				target[a->point[k].at] = a->point[k].target;
		for (size_t k = b->first[c]; k < b->first[c + 1]; k++)
			number += !b->point[k].outside && differ(target[b->point[k].at], b->point[k].target);
	}
	ts_free(target);
	if (ts_fluid_divided(fluid))
		ts_world_sum(fluid->slabs->world, &number);
	*points = (size_t)number;
	return TS_OK;
}
