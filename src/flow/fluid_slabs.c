#include "flow/fluid_slabs.h"

#include <string.h>

#include "base/banned.h"

struct ts_slabs_field ts_fluid_slabs_field(const struct ts_grid *grid, double *field)
{
	return (struct ts_slabs_field){ field + ts_at(grid, -grid->ghosts[0], -grid->ghosts[1], 0),
					(size_t)grid->stride[2], grid->ghosts[2], grid->ghosts[2] };
}

int ts_fluid_ranges(const struct ts_fluid *fluid)
{
	return ts_fluid_divided(fluid) ? fluid->planes.ranges : 1;
}

void ts_fluid_range_values(const struct ts_fluid *fluid, int range, size_t *first, size_t *end)
{
	const struct ts_grid *grid = &fluid->grid;
	const struct ts_fluid_range *planes = &fluid->planes.range[range];
	const size_t below = (size_t)(planes->from + grid->ghosts[2]),
		     to = (size_t)(planes->to + grid->ghosts[2]);

	*first = ts_fluid_divided(fluid) ? below * (size_t)grid->stride[2] : 0;
	/* behind the last ghosts there is a layer of faces */
	*end = ts_fluid_divided(fluid) && planes->to < grid->n[2] + grid->ghosts[2]
		       ? to * (size_t)grid->stride[2]
		       : grid->size;
}

bool ts_fluid_has_plane(const struct ts_fluid *fluid, int k)
{
	bool has = !ts_fluid_divided(fluid);

	for (int range = 0; range < fluid->planes.ranges; range++)
		has |= k >= fluid->planes.range[range].from && k < fluid->planes.range[range].to;
	return has;
}

void ts_fluid_copy_field(const struct ts_fluid *fluid, double *to, const double *from)
{
	for (int range = 0; range < ts_fluid_ranges(fluid); range++) {
		size_t first, end;

		ts_fluid_range_values(fluid, range, &first, &end);
		memcpy(to + first, from + first, (end - first) * sizeof *to);
	}
}

void ts_fluid_divide_field(const struct ts_fluid *fluid, double *field, double by)
{
	for (int range = 0; range < ts_fluid_ranges(fluid); range++) {
		size_t first, end;

		ts_fluid_range_values(fluid, range, &first, &end);
		for (size_t k = first; k < end; k++)
			field[k] /= by;
	}
}

void ts_fluid_slabs_planes(const struct ts_fluid *fluid, int *first, int *end)
{
	size_t from, to;

	ts_slabs_own(fluid->slabs, (size_t)fluid->grid.n[2], &from, &to);
	*first = (int)from;
	*end = (int)to;
}

void ts_fluid_slabs_rows(const struct ts_fluid *fluid, long *first, long *end)
{
	ts_slabs_rows(fluid->slabs, fluid->grid.n[2], fluid->grid.n[1], 0, first, end);
}

void ts_fluid_slabs_values(const struct ts_fluid *fluid, size_t *first, size_t *end)
{
	const struct ts_grid *grid = &fluid->grid;
	size_t n = (size_t)grid->n[2], from, to;

	ts_slabs_own(fluid->slabs, n, &from, &to);
	*first = from == 0 ? 0 : ts_at(grid, -grid->ghosts[0], -grid->ghosts[1], (int)from);
	*end = to == n ? grid->size : ts_at(grid, -grid->ghosts[0], -grid->ghosts[1], (int)to);
}

void ts_fluid_slabs_share(const struct ts_fluid *fluid, double *field)
{
	const struct ts_slabs_field all = ts_fluid_slabs_field(&fluid->grid, field);

	if (ts_slabs_ranks(fluid->slabs) > 1)
		ts_slabs_share(fluid->slabs, &all);
}

void ts_fluid_slabs_share_beside(const struct ts_fluid *fluid, double *field, int below, int above)
{
	const struct ts_slabs_field all = ts_fluid_slabs_field(&fluid->grid, field);

	ts_slabs_share_beside(fluid->slabs, &all, below, above, fluid->grid.periodic[2]);
}

void ts_fluid_slabs_share_halo(const struct ts_fluid *fluid, double *field)
{
	if (ts_fluid_divided(fluid))
		ts_fluid_slabs_share_beside(fluid, field, TS_GRID_GHOSTS, TS_GRID_GHOSTS);
	else
		ts_fluid_slabs_share(fluid, field);
}

double ts_fluid_slabs_most(const struct ts_fluid *fluid, double value)
{
	if (ts_slabs_ranks(fluid->slabs) > 1)
		ts_world_most(fluid->slabs->world, &value, 1);
	return value;
}
